//! `pinhole doctor`: checks this machine for what Pinhole uses.

use std::env;
use std::path::Path;
use std::process::Command;

use pinhole_course::checkout::Checkout;
use pinhole_course::error::Result;
use pinhole_course::handout_record::HandoutRecord;
use pinhole_course::mitsuba;
use pinhole_course::rust_tool::{rust_tool, tool};
use pinhole_course::sandbox::{Choice, Sandbox, has_landlock};
use pinhole_report::escape::printable;
use pinhole_report::program::Status;
use serde::Serialize;

use crate::cli::Doctor;

/// One thing that Pinhole uses.
#[derive(Serialize)]
struct Finding {
    name: &'static str,
    /// What it is needed for.
    used_for: &'static str,
    /// Whether nothing works without it.
    required: bool,
    is_there: bool,
    /// What was found, or what is wrong.
    found: String,
    /// What to do if it is missing.
    remedy: Option<String>,
}

/// What was found, or what is wrong.
type CheckResult = std::result::Result<String, String>;

impl Finding {
    fn required(
        name: &'static str,
        used_for: &'static str,
        found: CheckResult,
        remedy: &str,
    ) -> Finding {
        Finding {
            name,
            used_for,
            required: true,
            is_there: found.is_ok(),
            remedy: found.is_err().then(|| remedy.to_owned()),
            found: found.unwrap_or_else(|problem| problem),
        }
    }

    fn optional(
        name: &'static str,
        used_for: &'static str,
        found: CheckResult,
        remedy: &str,
    ) -> Finding {
        Finding {
            required: false,
            ..Finding::required(name, used_for, found, remedy)
        }
    }
}

/// Report less free space than this, in gigabytes. A build takes about 1 GB.
const ENOUGH_SPACE: f64 = 2.0;

pub fn run(checkout: &Checkout, arguments: &Doctor) -> Result<Status> {
    let mut findings = vec![
        rust(checkout.root()),
        linker(checkout.root()),
        space(checkout.root()),
        browser(),
    ];
    if HandoutRecord::read(checkout.root())?.is_none() {
        findings.push(sandbox(checkout));
        if cfg!(target_os = "linux") {
            findings.extend([landlock(), seccomp()]);
        }
        findings.extend([renderer(checkout), second_judge(checkout)]);
    }
    if arguments.json {
        anstream::println!("{:#}", serde_json::json!({ "findings": findings }));
    } else {
        for finding in &findings {
            print(finding);
        }
    }
    let lacks = |finding: &Finding| finding.required && !finding.is_there;
    Ok(match findings.iter().any(lacks) {
        true => Status::Incomplete,
        false => Status::Well,
    })
}

fn print(finding: &Finding) {
    let word = if finding.is_there { "ok" } else { "missing" };
    anstream::println!(
        "{word:7}  {:8}  {}",
        finding.name,
        printable(&finding.found)
    );
    if let Some(remedy) = &finding.remedy {
        let word = if finding.required {
            "required"
        } else {
            "optional"
        };
        anstream::println!("{:19}{word}: used {}", "", finding.used_for);
        anstream::println!("{:19}{}", "", printable(remedy));
    }
}

fn rust(root: &Path) -> Finding {
    let wanted = env!("CARGO_PKG_RUST_VERSION");
    let found = first_line(rust_tool("rustc", root).arg("--version"));
    Finding::required(
        "Rust",
        "to compile answers",
        found.and_then(|version| match is_at_least(&version, wanted) {
            true => Ok(version),
            false => Err(format!("{version} is older than {wanted}")),
        }),
        "run `rustup update stable`, or install Rust from rustup.rs",
    )
}

/// Whether `rustc 1.91.1 (…)` is at least `1.91`.
fn is_at_least(version: &str, wanted: &str) -> bool {
    let numbers = |text: &str| -> Vec<u32> {
        let number = text.split(' ').find(|word| word.contains('.'));
        let parts = number.unwrap_or(text).split(['.', '-']);
        parts.map_while(|part| part.parse().ok()).collect()
    };
    numbers(version) >= numbers(wanted)
}

fn linker(root: &Path) -> Finding {
    let remedy = match env::consts::OS {
        "macos" => "run `xcode-select --install`",
        "windows" => "install the C++ build tools of Visual Studio",
        _ => "install a C compiler (Debian: apt-get install gcc)",
    };
    // Only rustc can find Visual Studio's linker.
    let found = match cfg!(windows) {
        true => Ok("not checked on Windows".into()),
        false => first_line(tool("cc", root).arg("--version")),
    };
    Finding::required("linker", "to compile answers", found, remedy)
}

fn space(root: &Path) -> Finding {
    let found = match cfg!(windows) {
        true => Ok("not measured on Windows".into()),
        false => free_space(root).and_then(|free| {
            let text = format!("{free:.0} GB free");
            match free >= ENOUGH_SPACE {
                true => Ok(text),
                false => Err(text),
            }
        }),
    };
    Finding::required(
        "space",
        "to build in the `target` folder",
        found,
        &format!(
            "free up disk space until {ENOUGH_SPACE} GB are available; `cargo clean` removes old builds"
        ),
    )
}

/// Free space around a folder, in gigabytes.
fn free_space(folder: &Path) -> std::result::Result<f64, String> {
    let output = tool("df", folder).arg("-Pk").arg(folder).output();
    let output = output.map_err(|error| format!("cannot start df: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let row = text.lines().nth(1).unwrap_or_default();
    let free = row.split_whitespace().nth(3).map(str::parse::<f64>);
    match free {
        Some(Ok(kilobytes)) => Ok(kilobytes * 1024.0 / 1e9),
        _ => Err("df did not report how much space is free".into()),
    }
}

fn browser() -> Finding {
    let names = ["firefox", "chromium", "chromium-browser", "google-chrome"];
    let on_path = |name: &&str| {
        let path = env::var_os("PATH").unwrap_or_default();
        env::split_paths(&path).any(|folder| folder.join(name).is_file())
    };
    let found = match env::consts::OS {
        "macos" | "windows" => Some("the system's"),
        _ => names.into_iter().find(on_path),
    };
    Finding::optional(
        "browser",
        "to look at reports and the book",
        found.map(str::to_owned).ok_or_else(|| "none found".into()),
        "install a browser, or copy target/pinhole/report.html to a machine that has one",
    )
}

fn sandbox(checkout: &Checkout) -> Finding {
    let made = Sandbox::for_untrusted("a submission", checkout, Choice::Bubblewrap, &[]);
    let (found, remedy) = match made {
        Ok(_) => (Ok("bubblewrap works".into()), String::new()),
        Err(error) => (Err(error.problem), error.remedy),
    };
    Finding::optional(
        "sandbox",
        "to run other people's code: with `grade`, or with `check` on a folder outside the repository",
        found,
        &remedy,
    )
}

fn landlock() -> Finding {
    let found = match has_landlock() {
        true => Ok("the kernel has it".into()),
        false => Err("the kernel was built without it, or it is switched off".into()),
    };
    Finding::optional(
        "Landlock",
        "to hide files from code that runs with `--sandbox container`; bubblewrap works without it",
        found,
        "boot Linux 5.13 or newer, with `landlock` listed in the kernel parameter `lsm=`",
    )
}

fn seccomp() -> Finding {
    let found = match Path::new("/proc/sys/kernel/seccomp/actions_avail").is_file() {
        true => Ok("the kernel has it".into()),
        false => Err("the kernel does not have it".into()),
    };
    Finding::optional(
        "seccomp",
        "to keep other people's code from making dangerous system calls",
        found,
        "use a Linux kernel with CONFIG_SECCOMP_FILTER",
    )
}

fn renderer(checkout: &Checkout) -> Finding {
    Finding::optional(
        "Mitsuba",
        "to render golden films, and to make fresh questions for `grade`",
        mitsuba_version(checkout),
        "run `cargo pinhole golden setup`",
    )
}

fn mitsuba_version(checkout: &Checkout) -> CheckResult {
    let question = "from importlib.metadata import version; print(version('mitsuba'))";
    match mitsuba::is_there(checkout) {
        true => first_line(mitsuba::python(checkout).args(["-I", "-c", question])),
        false => Err("not installed".into()),
    }
}

fn second_judge(checkout: &Checkout) -> Finding {
    let found = pinhole::oiiotool::Oiiotool::find(&mitsuba::environment(checkout));
    Finding::optional(
        "oiiotool",
        "to judge every film a second time, with `check --oiiotool`",
        match found {
            Some(tool) => first_line(Command::new(tool.binary()).arg("--version")),
            None => Err("not installed".into()),
        },
        "run `cargo pinhole golden setup`",
    )
}

/// The first line that a program prints.
fn first_line(command: &mut Command) -> CheckResult {
    let name = command.get_program().display().to_string();
    match command.output() {
        Ok(output) if output.status.success() => {
            let text = String::from_utf8_lossy(&output.stdout);
            Ok(text.lines().next().unwrap_or_default().to_owned())
        }
        Ok(output) => Err(format!("{name} fails: {}", output.status)),
        Err(error) => Err(format!("cannot start {name}: {error}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_compared_by_number_and_not_as_text() {
        assert!(is_at_least("rustc 1.100.0 (abc 2027-01-01)", "1.91"));
        assert!(is_at_least("rustc 1.91.0", "1.91"));
        assert!(is_at_least("rustc 1.92.0-nightly (abc)", "1.91"));
        assert!(!is_at_least("rustc 1.9.0 (abc)", "1.91"));
        assert!(!is_at_least("rustc 1.90.3 (abc)", "1.91"));
    }

    #[test]
    fn a_program_that_is_not_there_is_a_finding() {
        let found = first_line(&mut Command::new("no-such-program"));
        assert!(
            found
                .unwrap_err()
                .starts_with("cannot start no-such-program")
        );
    }
}
