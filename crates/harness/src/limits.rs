//! What each submission may use.

use std::collections::BTreeMap;
use std::time::Duration;

use clap::Args;
use sandbox::Limits;

/// What each submission may use. The defaults are many times what honest work needs.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Limits for each submission")]
pub struct LimitArgs {
    /// Processor time of the compiler, in seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..=3600))]
    pub compile_cpu: u64,
    /// Time of the compiler by the clock, in seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 20, value_parser = clap::value_parser!(u64).range(1..=3600))]
    pub compile_wall: u64,
    /// Memory of the compiler, in MiB of address space
    #[arg(long, value_name = "MIB", default_value_t = 3072, value_parser = clap::value_parser!(u64).range(512..=1_000_000))]
    pub compile_memory: u64,
    /// The largest file that the compiler may write, in MiB
    #[arg(long, value_name = "MIB", default_value_t = 64, value_parser = clap::value_parser!(u64).range(1..=100_000))]
    pub compile_disk: u64,
    /// Messages of the compiler that are read, in MiB
    #[arg(long, value_name = "MIB", default_value_t = 16, value_parser = clap::value_parser!(u64).range(1..=1000))]
    pub compile_output: u64,
    /// Processor time of the student's functions, in seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 20, value_parser = clap::value_parser!(u64).range(1..=3600))]
    pub run_cpu: u64,
    /// Time for each check by the clock, in seconds; after the first that takes longer, each has a tenth of it, or half a
    /// second
    #[arg(long, value_name = "SECONDS", default_value_t = 2.0, value_parser = seconds)]
    pub run_wall: f64,
    /// Memory of the student's functions, in MiB of address space
    #[arg(long, value_name = "MIB", default_value_t = 1024, value_parser = clap::value_parser!(u64).range(64..=1_000_000))]
    pub run_memory: u64,
    /// Threads that the compiler or the functions may have
    #[arg(long, value_name = "COUNT", default_value_t = 64, value_parser = clap::value_parser!(u32).range(8..=10_000))]
    pub threads: u32,
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    if (0.1..=3600.0).contains(&seconds) { Ok(seconds) } else { Err("not between 0.1 and 3600".to_owned()) }
}

const MIB: u64 = 1 << 20;

impl LimitArgs {
    /// For the compiler and the linker.
    pub fn compile(&self) -> Limits {
        Limits {
            cpu: Duration::from_secs(self.compile_cpu),
            wall: Duration::from_secs(self.compile_wall),
            memory: self.compile_memory * MIB,
            threads: self.threads,
            output: usize::try_from(self.compile_output * MIB).unwrap_or(usize::MAX),
            file_size: self.compile_disk * MIB,
        }
    }

    /// For the student's functions. What they print is thrown away, and they write no file.
    pub fn run(&self) -> Limits {
        Limits {
            cpu: Duration::from_secs(self.run_cpu),
            wall: Duration::from_secs(3600),
            memory: self.run_memory * MIB,
            threads: self.threads,
            output: 0,
            file_size: 0,
        }
    }

    /// For each check.
    pub fn patience(&self) -> Duration {
        Duration::from_secs_f64(self.run_wall)
    }

    /// In words, for the record.
    pub fn in_words(&self) -> BTreeMap<String, String> {
        let lines = [
            ("compile, processor time", format!("{} s", self.compile_cpu)),
            ("compile, time", format!("{} s", self.compile_wall)),
            ("compile, memory", format!("{} MiB", self.compile_memory)),
            ("compile, file", format!("{} MiB", self.compile_disk)),
            ("compile, messages", format!("{} MiB", self.compile_output)),
            ("run, processor time", format!("{} s", self.run_cpu)),
            ("run, time for each check", format!("{} s", self.run_wall)),
            ("run, memory", format!("{} MiB", self.run_memory)),
            ("threads", self.threads.to_string()),
        ];
        lines.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
    }
}
