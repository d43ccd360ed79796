//! Makes the book's pictures again: `cargo pictures`.

use std::path::Path;
use std::process::ExitCode;

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
    let mut studio = Studio::new(read("running.bvh")?, read("dance.bvh")?);
    let folder = workspace.join("docs").join("pictures");
    std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for made in PICTURES {
        let name = format!("{}.png", made.name);
        picture::save(&made.draw(&mut studio), &folder.join(&name))
            .map_err(|error| format!("{name}: {error}"))?;
        println!("docs/pictures/{name}");
    }
    Ok(())
}
