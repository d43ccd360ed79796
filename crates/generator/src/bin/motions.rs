//! `cargo motions`: writes the motions of the folder `data/` again.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;

/// Writes the project's motions, and the positions expected of them.
#[derive(Parser)]
struct Arguments {
    /// The folder to write into; it is made if it is not there. Files of the same names are replaced.
    #[arg(long, value_name = "DIR", default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data"))]
    out: PathBuf,
}

fn main() -> ExitCode {
    let Arguments { out } = Arguments::parse();
    match write_all(&out) {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("error: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn write_all(out: &Path) -> Result<(), String> {
    let files = generator::data_files().map_err(|error| error.to_string())?;
    std::fs::create_dir_all(out)
        .map_err(|error| format!("cannot make the folder {}: {error}", out.display()))?;
    for file in files {
        let path = out.join(&file.name);
        std::fs::write(&path, &file.contents)
            .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
        println!("{:>9} bytes  {}", file.contents.len(), path.display());
    }
    Ok(())
}
