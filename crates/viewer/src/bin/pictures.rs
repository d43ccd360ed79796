//! Makes the book's pictures again, and the tables of its experiment: `cargo pictures`.

use std::path::Path;
use std::process::ExitCode;

use viewer::motion::source::Source;
use viewer::output::edit::experiment::Experiment;
use viewer::output::picture;
use viewer::output::pictures::{PICTURES, Studio};

fn main() -> ExitCode {
    match make() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn make() -> Result<(), String> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join("..");
    let read = |name: &str| {
        let read = parser::bvh::read_file(workspace.join("data").join(name));
        read.map(|read| read.motion).map_err(|error| error.to_string())
    };
    let data = |name: &str| workspace.join("data").join(name);
    let walk = Source { skeleton: Some(data("walk.asf")), ..Source::new(data("walk.amc")) };
    let walk = walk.read().map_err(|error| error.to_string())?.stage;
    let mut studio = Studio::new(read("running.bvh")?, read("dance.bvh")?, walk);
    let folder = workspace.join("docs").join("pictures");
    std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for made in PICTURES {
        let name = format!("{}.png", made.name);
        picture::save(&made.draw(&mut studio), &folder.join(&name))
            .map_err(|error| format!("{name}: {error}"))?;
        println!("docs/pictures/{name}");
    }
    // The optimum of a long motion takes a minute or two.
    let written = Experiment::new(&workspace.join("data"))?.write(&workspace.join("docs"))?;
    written.iter().for_each(|name| println!("{name}"));
    Ok(())
}
