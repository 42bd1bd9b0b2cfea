//! Runs the Python scripts that render goldens, in a Python environment of the project's own.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf, absolute};
use std::process::{Command, Stdio};

use serde::Deserialize;

use crate::checkout::Checkout;
use crate::error::{Error, Result, ResultExt};
use crate::progress::Progress;
use crate::rust_tool::{in_folder, programs};
use crate::seed::Seed;

/// The folder of the Python environment.
pub fn environment(checkout: &Checkout) -> PathBuf {
    scripts(checkout).join(".venv")
}

/// The folder of the scripts.
pub fn scripts(checkout: &Checkout) -> PathBuf {
    checkout.root().join("tools").join("mitsuba")
}

/// Whether the environment exists.
pub fn is_there(checkout: &Checkout) -> bool {
    interpreter(&environment(checkout)).is_file()
}

/// A command that runs the environment's Python. Add arguments: a script, or `-I` before `-c` and
/// `-m`, which would else import modules of the current folder first, and a student's may hold any.
pub fn python(checkout: &Checkout) -> Command {
    Command::new(interpreter(&environment(checkout)))
}

/// Makes the environment, or repairs it.
pub fn setup(checkout: &Checkout) -> Result<()> {
    let environment = environment(checkout);
    let mut venv = system_python(checkout)?;
    // After an upgrade of the system's Python, an old environment doesn't find its own
    // packages.
    let mut own_pip = Command::new(interpreter(&environment));
    let own_pip = own_pip
        .args(["-I", "-c", "import pip"])
        .stderr(Stdio::null());
    if !own_pip.status().is_ok_and(|status| status.success()) {
        complete(
            venv.args(["-I", "-m", "venv", "--clear"]).arg(&environment),
            "make a Python environment",
        )?;
    }
    let mut pip = Command::new(interpreter(&environment));
    pip.args([
        "-I",
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
    ]);
    for folder in [scripts(checkout), scripts(checkout).join("tests")] {
        pip.arg("-r").arg(folder.join("requirements.txt"));
    }
    complete(&mut pip, "install Mitsuba and oiiotool")
}

/// Python's flags for one of our scripts, which imports modules beside it. The variable `PYTHONPATH`
/// may name the current folder, which may be a student's, so it is ignored. Nothing is written
/// beside the script.
const OWN_MODULES: [&str; 2] = ["-E", "-B"];

/// The system's Python, started in the folder of our scripts. If asdf has installed it, a file of the
/// folder where it starts can name any program to run instead.
fn system_python(checkout: &Checkout) -> Result<Command> {
    let start = |program: PathBuf| in_folder(program, &scripts(checkout));
    let runs = |program: &PathBuf| {
        let version = start(program.clone()).arg("--version").output();
        version.is_ok_and(|output| output.status.success())
    };
    let mut all = ["python3", "python"].into_iter().flat_map(programs);
    let found = all.find(runs).map(start);
    found.ok_or_else(|| {
        Error::environment("there is no Python here", "install Python 3.11 or newer")
    })
}

/// Which questions were drawn, and the folder of the assignment they were drawn for.
#[derive(Clone, Copy, Debug)]
pub enum QuestionSet<'a> {
    /// The committed questions of its tasks, and its ties.
    Public(&'a Path),
    /// Questions and scenes that no student has seen.
    Fresh(&'a Path),
}

/// Fingerprints of the scripts behind the films of these scenes and of what was drawn. Needs
/// Python, but not Mitsuba. A checkout without scripts, such as a student's, has no
/// fingerprints.
///
/// # Errors
/// If there is no Python, or a script cannot be read.
pub fn fingerprints(
    checkout: &Checkout,
    scenes: &[PathBuf],
    drawn: Option<QuestionSet>,
) -> Result<BTreeMap<String, String>> {
    let script = scripts(checkout).join("fingerprint.py");
    if !script.is_file() {
        return Ok(BTreeMap::new());
    }
    let failed = Error::environment(
        "cannot tell whether the golden scripts have changed",
        "install Python 3.11 or newer; if a script is missing or broken, restore it",
    );
    let python = system_python(checkout);
    let mut command = python.map_err(|error| failed.because(error.problem))?;
    command.args(OWN_MODULES).arg(script);
    for scene in scenes {
        command.arg(absolute(scene).or_fail(&failed)?);
    }
    if let Some(drawn) = drawn {
        let (option, assignment) = match drawn {
            QuestionSet::Public(assignment) => ("--questions", assignment),
            QuestionSet::Fresh(assignment) => ("--fresh", assignment),
        };
        command
            .arg(option)
            .arg(absolute(assignment).or_fail(&failed)?);
    }
    let output = command.output().or_fail(&failed)?;
    serde_json::from_slice(&output.stdout)
        .map_err(|_| failed.because(String::from_utf8_lossy(&output.stderr).trim_end()))
}

fn complete(command: &mut Command, purpose: &str) -> Result<()> {
    let status = command.stdout(Stdio::null()).status();
    if status.as_ref().is_ok_and(|status| status.success()) {
        return Ok(());
    }
    Err(Error::environment(
        format!("cannot {purpose}: {command:?} failed"),
        "see the message above; this needs Python 3.11 or newer, with venv, and access to a package \
         index",
    ))
}

fn interpreter(environment: &Path) -> PathBuf {
    match cfg!(windows) {
        true => environment.join("Scripts").join("python.exe"),
        false => environment.join("bin").join("python"),
    }
}

/// One finished item of the scripts.
#[derive(Clone, Debug, Deserialize)]
pub struct Item {
    /// A scene's name, or that of a group of questions: `TASK.GROUP`.
    pub name: String,
    /// The files made, relative to the output folder.
    pub files: Vec<PathBuf>,
}

/// The renderer that made the films.
#[derive(Clone, Debug, Deserialize)]
pub struct Renderer {
    /// Mitsuba's version.
    pub mitsuba: String,
    /// Its variant.
    pub variant: String,
    total: usize,
}

/// What a run of the scripts has made.
pub struct RenderResult {
    /// The renderer.
    pub renderer: Renderer,
    /// Everything that was made.
    pub items: Vec<Item>,
    /// Why something was not made, in the words of the scripts.
    pub refusal: Option<Error>,
}

/// Runs `golden.py` and returns what it made. The scripts get the seed, if there is one, where other
/// users of the machine can't read it.
///
/// # Errors
/// If the environment is missing, or the scripts fail.
pub fn render(
    checkout: &Checkout,
    arguments: &[&OsStr],
    seed: Option<Seed>,
    progress: &Progress,
) -> Result<RenderResult> {
    let python = interpreter(&environment(checkout));
    if !python.is_file() {
        return Err(Error::environment(
            "Mitsuba is not installed here",
            "install it: cargo pinhole golden setup",
        ));
    }
    let failed = Error::environment(
        "cannot run Mitsuba",
        "install it again: cargo pinhole golden setup",
    );
    let mut child = Command::new(python)
        .args(OWN_MODULES)
        .arg(scripts(checkout).join("golden.py"))
        .args(arguments)
        .envs(seed.map(|seed| ("PINHOLE_SEED", seed.to_string())))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .or_fail(&failed)?;
    let complaints = child
        .stderr
        .take()
        .map(|pipe| std::thread::spawn(move || std::io::read_to_string(pipe).unwrap_or_default()));
    let mut lines = BufReader::new(child.stdout.take().expect("it was piped")).lines();
    let renderer = lines.next().transpose().or_fail(&failed)?;
    let renderer: Option<Renderer> = renderer.and_then(|line| serde_json::from_str(&line).ok());
    let mut items = Vec::new();
    for line in lines {
        if let Ok(item) = serde_json::from_str::<Item>(&line.or_fail(&failed)?) {
            items.push(item);
            let total = renderer
                .as_ref()
                .map_or(1, |renderer| renderer.total.max(1));
            progress.show("Mitsuba", items.len() as f64 / total as f64);
        }
    }
    let status = child.wait().or_fail(&failed)?;
    let said = complaints
        .and_then(|thread| thread.join().ok())
        .unwrap_or_default();
    let refusal = (status.code() == Some(2)).then(|| {
        Error::input(
            format!("Mitsuba refused:\n{}", said.trim_end()),
            "change the scene as the message says",
        )
    });
    match renderer {
        Some(renderer) if status.success() || refusal.is_some() => Ok(RenderResult {
            renderer,
            items,
            refusal,
        }),
        _ => Err(Error::environment(
            format!("the golden scripts failed ({status}):\n{}", said.trim_end()),
            "install Mitsuba and oiiotool again: cargo pinhole golden setup",
        )),
    }
}
