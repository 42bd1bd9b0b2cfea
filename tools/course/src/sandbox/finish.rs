//! Runs a command until it ends or exceeds a limit.

use std::io::{self, Read};
use std::process::{Command, ExitStatus, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use pinhole::ask::{BUSY, Death};

use super::watch::{ExceededLimit, Watch};
use super::{Limits, own_clock};

/// How a command ended.
#[derive(Debug)]
pub struct CommandResult {
    /// How it ended.
    pub status: ExitStatus,
    /// Its standard error, cut at [`MOST_SAID`] bytes.
    pub stderr: Vec<u8>,
    /// The limit that ended it, if one did.
    pub exceeded: Option<ExceededLimit>,
    /// Whether the clock ended it.
    pub late: bool,
    /// How long other work kept it from running.
    pub waited: Duration,
    /// Whether that is why it was late.
    pub starved: bool,
}

impl CommandResult {
    /// What else on this machine kept it from finishing, if that is certain.
    pub fn disturbed_by(&self) -> Option<&'static str> {
        match self.exceeded {
            _ if self.starved => Some("other work kept the compiler from running"),
            None if !self.late && Death::of(Some(self.status)).may_be_kill() => {
                Some("something killed the compiler, perhaps because memory ran out")
            }
            _ => None,
        }
    }

    /// Whether it might have finished at another time: it exceeded a limit on time, or was killed
    /// by something else than our limits, as the kernel does if the machine runs out of memory.
    pub fn is_late(&self) -> bool {
        let is_late = match self.exceeded {
            Some(exceeded) => matches!(exceeded, ExceededLimit::Cpu(_) | ExceededLimit::Idle(_)),
            None => Death::of(Some(self.status)).may_be_kill(),
        };
        self.late || is_late
    }
}

/// The most of its standard error that is kept. The rest is read and thrown away.
pub const MOST_SAID: usize = 1 << 20;

/// The time between two checks of whether a command has ended.
const PAUSE: Duration = Duration::from_millis(2);

/// The time between two looks at its own clock, which take a while.
const LOOK: Duration = Duration::from_millis(50);

/// Runs a command without standard input and output, and collects its standard error. Calls
/// `watch` with the command's process id.
pub fn finish(
    mut command: Command,
    limits: &Limits,
    watch: impl FnOnce(u32) -> Watch,
) -> io::Result<CommandResult> {
    let begun = Instant::now();
    command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::piped());
    let mut child = command.spawn()?;
    let watch = watch(child.id());
    let (sender, said) = mpsc::channel();
    if let Some(mut pipe) = child.stderr.take() {
        std::thread::spawn(move || {
            let mut kept = Vec::new();
            let beginning = (&mut pipe).take(MOST_SAID as u64).read_to_end(&mut kept);
            let rest = beginning.and_then(|_| io::copy(&mut pipe, &mut io::sink()));
            // A broken pipe ends the text. If nobody waits for the text any more, sending it fails,
            // which does no harm.
            let _ = (rest, sender.send(kept));
        });
    }
    // Its own time tells whether it is late, within limits.
    let mut clock = own_clock(child.id());
    let mut own_time = Duration::ZERO;
    let mut looked = begun;
    let (mut late, mut starved) = (false, false);
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if looked.elapsed() >= LOOK {
            (own_time, looked) = (clock(), Instant::now());
        }
        starved = begun.elapsed() >= limits.wall * BUSY;
        late = starved || own_time >= limits.wall;
        if late {
            let _already_gone = child.kill();
            break child.wait()?;
        }
        std::thread::sleep(PAUSE);
    };
    let exceeded = watch.stop();
    // Don't wait for a process that was left behind and still holds the pipe.
    let stderr = said
        .recv_timeout(Duration::from_secs(2))
        .unwrap_or_default();
    Ok(CommandResult {
        status,
        stderr,
        exceeded,
        late,
        waited: (looked - begun).saturating_sub(own_time),
        starved,
    })
}
