//! What is expected of a sandbox, whatever its kind.

use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use glam::DVec3;
use pinhole::Ray;
use pinhole::ask::{Ending, Reply, Stop};
use pinhole::job::Job;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::Result;
use pinhole_course::sandbox::{Choice, Limits, Sandbox};

use crate::modes::{CONTAINER, UNREACHABLE, USER, WITHOUT_LANDLOCK, sysroot};
use crate::report::{expect, while_answering, while_compiling};

const PROBE: &str = include_str!("probe.rs");

/// A sandbox, and the probe in it.
struct Walls<'a> {
    mode: &'a str,
    checkout: Checkout,
    choice: Choice,
    sandbox: Sandbox,
    /// The folders of the submission and of the libraries.
    folder: PathBuf,
    harness: PathBuf,
    /// The submission's program.
    program: PathBuf,
}

/// Checks the sandbox that this mode is for.
pub fn judge(mode: &str) {
    let course = std::env::current_dir().expect("it is there");
    if mode == UNREACHABLE {
        return refuse_toolchain(&course);
    }
    // An ordinary user may run these tests.
    let is_root = rustix::process::getuid().is_root();
    let walls = Walls::new(if is_root { mode } else { USER }, &course);
    walls.refuse_what_they_would_show();
    let user = walls.confine_the_compiler();
    walls.confine_an_answer(user);
    walls.separate_submissions(user);
    walls.shorten_limits();
    walls.report_that_they_fell();
}

impl<'a> Walls<'a> {
    fn new(mode: &'a str, course: &Path) -> Walls<'a> {
        let choice = match mode {
            CONTAINER => Choice::Container,
            WITHOUT_LANDLOCK => Choice::ContainerWithoutLandlock,
            _ => Choice::Auto,
        };
        let checkout = Checkout::at(course);
        let sandbox = Sandbox::for_untrusted("it", &checkout, choice, &[]);
        let sandbox = sandbox.unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(sandbox.name(), mode.trim_end_matches(" as a user"));
        let scratch = sandbox.scratch(&checkout);
        Walls {
            mode,
            checkout,
            choice,
            sandbox,
            program: scratch.join("submission/probe"),
            folder: scratch.join("submission"),
            harness: scratch.join("harness"),
        }
    }

    fn is_container(&self) -> bool {
        [CONTAINER, WITHOUT_LANDLOCK].contains(&self.mode)
    }

    /// Whether the code runs as a user that is not ours.
    fn is_another_user(&self) -> bool {
        self.mode != USER
    }

    fn made(&self, choice: Choice, secrets: &[PathBuf]) -> Result<Sandbox> {
        Sandbox::for_untrusted("it", &self.checkout, choice, secrets)
    }

    fn refuse_what_they_would_show(&self) {
        let refused = self.made(self.choice, &["/usr/secret".into()]);
        assert!(refused.is_err(), "code may read /usr");
        // Everyone may pass through this folder.
        let above = self.checkout.root().parent().expect("it is in a folder");
        let is_hidden = self.made(self.choice, &[above.into()]).is_ok();
        assert_eq!(is_hidden, self.mode != WITHOUT_LANDLOCK);
        if self.mode == WITHOUT_LANDLOCK {
            let refused = self.made(Choice::Container, &[]);
            assert!(refused.is_err(), "nobody accepted that");
        }
        let around = |folder| {
            let made = Sandbox::around(folder, &self.checkout, self.choice, &[]);
            made.map(|sandbox| sandbox.name())
        };
        assert_eq!(around(Path::new("/srv")).ok(), Some(self.sandbox.name()));
        if self.is_container() {
            let refused = self.made(Choice::Auto, &[]);
            assert!(refused.is_err(), "there are no namespaces");
        } else {
            assert_eq!(around(self.checkout.root()).ok(), Some("none"));
        }
    }

    fn limits_of_compiler(&self) -> Limits {
        Limits {
            cpu: Duration::from_secs(7),
            ..Limits::of_compiler()
        }
    }

    fn compiler(&self) -> Command {
        let limits = self.limits_of_compiler();
        let made = self.sandbox.compiler(&self.folder, &self.harness, &limits);
        made.expect("it can be made")
    }

    /// Compiles the probe, and runs it in place of the compiler. Returns its user id.
    fn confine_the_compiler(&self) -> u32 {
        let (source, out) = (self.folder.join("src"), self.folder.join("out"));
        for folder in [&source, &out, &self.harness] {
            fs::create_dir_all(folder).expect("a folder can be made");
        }
        let places = format!(
            "const ROOT: &str = {:?}; const FOLDER: &str = {:?};",
            self.checkout.root(),
            self.folder
        );
        fs::write(source.join("probe.rs"), PROBE.to_owned() + &places).expect("there is room");
        let limits = self.limits_of_compiler();
        let compile = |command| {
            let finished = self.sandbox.compile(command, &limits).expect("it starts");
            let said = String::from_utf8(finished.stderr).expect("it is text");
            (finished.status.success(), said)
        };
        let mut rustc = self.compiler();
        rustc.args(["src/probe.rs", "--edition=2024", "-oout/probe"]);
        let (compiles, said) = compile(rustc);
        assert!(compiles, "{said}");
        fs::rename(out.join("probe"), &self.program).expect("it was compiled");

        let copy = self.harness.join("probe");
        fs::copy(&self.program, &copy).expect("there is room");
        let (_, report) = compile(instead_of_rustc(self.compiler(), &copy));
        let user = report.split(['[', ',']).nth(1).expect("it tells its user");
        let user = user.parse().expect("a number");
        expect(&report, &while_compiling(self.mode, user, &limits));
        if self.is_container() {
            let about = fs::metadata(&self.folder).expect("it is there");
            assert_eq!(about.mode() & 0o777, 0o700, "others may look inside");
        }
        // Both ended in time.
        assert_eq!(self.sandbox.within_budget(&limits), limits);
        if self.is_another_user() {
            assert!(
                (60_706..=61_183).contains(&user),
                "{user} may be somebody's"
            );
            all_end(user);
        }
        user
    }

    fn limits_of_answers(&self) -> Limits {
        Limits {
            cpu: Duration::from_secs(7),
            ..Limits::of_answers(Duration::from_secs(60))
        }
    }

    fn ask(&self, sandbox: &Sandbox) -> std::io::Result<Reply> {
        let ray = Ray {
            origin: DVec3::ZERO,
            direction: DVec3::Z,
        };
        let job = Job::Cast(ray, 0.0, Vec::new());
        let limits = self.limits_of_answers();
        sandbox.ask(&self.program, &job, &limits, Stop::default(), &mut |_| {})
    }

    /// Seals the probe, and runs it as an answer.
    fn confine_an_answer(&self, user: u32) {
        let is_sealed = || self.sandbox.is_sealed(&self.program);
        assert_eq!(is_sealed(), !self.is_another_user(), "before it is ours");
        let sealed = self.sandbox.seal(&self.folder, &self.program);
        sealed.expect("it can be handed over");
        assert!(is_sealed(), "after it became ours");
        let about = fs::metadata(&self.program).expect("it is there");
        let expected = if self.is_another_user() { 0o711 } else { 0o700 };
        assert_eq!(about.mode() & 0o777, expected);
        if self.is_container() {
            let about = fs::metadata(&self.folder).expect("it is there");
            let owners = (about.uid(), about.gid(), about.mode() & 0o777);
            assert_eq!(owners, (0, user, 0o710));
        }
        let report = self.ask(&self.sandbox).expect("it works").printed;
        let expected = while_answering(self.mode, user, &self.limits_of_answers());
        expect(&report, &expected);
    }

    fn separate_submissions(&self, user: u32) {
        let other = self.sandbox.new_instance(Duration::from_secs(600));
        let other = other.expect("an id is left");
        assert!(!other.is_done_compiling());
        let report = self.ask(&other).expect("it works").printed;
        if self.is_container() {
            // The other user may not start this one's program.
            assert_ne!(other.fingerprint(), self.sandbox.fingerprint());
            assert!(report.contains("Permission denied"), "{report}");
        } else {
            assert_eq!(other.fingerprint(), format!("bubblewrap {}", sysroot()));
            let is_same = report.starts_with(&format!("user [{user}"));
            assert_eq!(is_same, !self.is_another_user(), "{report}");
        }
        let late = self.sandbox.new_instance(Duration::ZERO);
        let late = late.expect("an id is left");
        assert!(late.is_done_compiling());
        let reply = self.ask(&late).expect("nothing is started");
        assert_eq!(reply.ending, Ending::OutOfTime(Duration::ZERO));
    }

    /// Limits get shorter after a submission has exceeded two.
    fn shorten_limits(&self) {
        let limits = Limits {
            cpu: Duration::from_millis(100),
            ..self.limits_of_compiler()
        };
        for _ in 0..2 {
            assert_eq!(self.sandbox.within_budget(&limits), limits);
            let endless = instead_of_rustc(self.compiler(), Path::new("/usr/bin/yes"));
            let finished = self.sandbox.compile(endless, &limits);
            let exceeded = finished.expect("it starts").exceeded;
            let exceeded = exceeded.map(|limit| limit.to_string());
            assert_eq!(
                exceeded.as_deref(),
                Some("more than 0.1 s of processor time")
            );
        }
        assert_eq!(self.sandbox.within_budget(&limits), limits.shortened());
    }

    /// No student is blamed when the sandbox stops working.
    fn report_that_they_fell(self) {
        let own = std::env::current_exe().expect("it is a file");
        fs::remove_file(&own).expect("it is ours");
        fs::copy("/usr/bin/false", &own).expect("there is room");
        assert!(self.ask(&self.sandbox).is_err(), "the student is blamed");
        assert!(self.made(self.choice, &[]).is_err(), "it does not work");
        let is_container = self.is_container();
        drop(self.sandbox);
        assert_eq!(
            self.folder.exists(),
            !is_container,
            "the container's folder"
        );
    }
}

/// Checks that a toolchain that the code's user can't reach is refused.
fn refuse_toolchain(course: &Path) {
    let refused = || {
        let checkout = Checkout::at(course);
        let made = Sandbox::for_untrusted("it", &checkout, Choice::Container, &[]);
        made.expect_err("nobody can compile").to_string()
    };
    assert!(refused().contains("cannot ask rustc"), "{}", refused());
    let sysroot = course.to_str().expect("a plain name");
    fs::write(course.join("sysroot"), sysroot).expect("there is room");
    assert!(
        refused().contains("another user cannot reach"),
        "{}",
        refused()
    );
}

/// The compiler's command, with another program.
fn instead_of_rustc(compiler: Command, program: &Path) -> Command {
    let words: Vec<_> = compiler.get_args().collect();
    let end = words.iter().rposition(|word| *word == "--");
    let mut command = Command::new(compiler.get_program());
    command
        .args(&words[..=end.expect("it ends the options")])
        .arg(program);
    command.env_clear();
    for (name, value) in compiler.get_envs() {
        command.env(name, value.expect("it is set"));
    }
    if let Some(folder) = compiler.get_current_dir() {
        command.current_dir(folder);
    }
    command
}

/// Waits until a user has no process.
#[track_caller]
fn all_end(user: u32) {
    let start = Instant::now();
    let all = || {
        let all = fs::read_dir("/proc").expect("it is there").flatten();
        let theirs = all.filter(|entry| entry.metadata().is_ok_and(|about| about.uid() == user));
        let about = |entry: fs::DirEntry| fs::read_to_string(entry.path().join("stat")).ok();
        theirs.filter_map(about).collect::<Vec<_>>()
    };
    while !all().is_empty() {
        let left = all();
        assert!(
            start.elapsed() < Duration::from_secs(5),
            "left behind: {left:?}"
        );
        std::thread::sleep(Duration::from_millis(10));
    }
}
