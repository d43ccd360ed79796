//! `cargo doctor`: what this machine offers.

use std::process::ExitCode;

use clap::Args;

use crate::grade::Scratch;
use crate::kit::Kit;
use crate::marker;
use crate::toolchain::{Linker, Toolchain};
use crate::{Error, workspace};

/// Shows what this machine offers for marking, what is missing, and how to get it
#[derive(Args, Clone, Debug)]
pub struct DoctorArgs {}

/// Runs the command. The exit code is 1 when nothing can be marked safely here.
///
/// # Errors
///
/// When there is no toolchain, or the libraries cannot be built.
pub fn run(_: &DoctorArgs) -> Result<ExitCode, Error> {
    let workspace = workspace::find()?;
    let toolchain = Toolchain::find(&workspace)?;
    println!("Compiler   {}", toolchain.version);
    match &toolchain.linker {
        Linker::Direct { program, .. } => println!("Linker     {}", program.display()),
        Linker::ByRustc => println!(
            "Linker     by the compiler: twice as slow. Called directly it needs Linux with the GNU C library."
        ),
    }
    let kit = Kit::build(&workspace, &toolchain)?;
    println!("Libraries  built");

    let target = workspace::target(&workspace).join("worker");
    let target = target.canonicalize().map_err(|error| Error::read(&target, error))?;
    let scratch = Scratch::new(&target)?;
    let launcher = marker::launcher()?;
    let reads = marker::reads(&toolchain, &kit, scratch.path());
    println!("\nSandbox");
    for finding in sandbox::findings(&launcher, &reads) {
        println!("{finding}");
    }
    match sandbox::Sandbox::strongest(launcher, &reads) {
        Ok(sandbox) => {
            println!("\nSubmissions are confined by: {}", sandbox.layers());
            Ok(ExitCode::SUCCESS)
        }
        Err(unavailable) => {
            println!("\n{unavailable}");
            println!(
                "Without that, `cargo grade` marks only with `--unsandboxed`, and says so in every result."
            );
            Ok(ExitCode::FAILURE)
        }
    }
}
