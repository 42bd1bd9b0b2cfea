//! The real command on the real course: real Mitsuba, oiiotool, compiler, sandbox.

mod browser;
mod check;
#[cfg(target_os = "linux")]
mod container;
mod course;
mod diagnosis;
mod diff;
mod explain;
mod golden;
mod grade;
mod handout;
#[cfg(target_os = "linux")]
mod hostile;
mod house;
mod report;
mod sandbox;
mod study;
mod submissions;
mod validate;
mod watch;
#[cfg(unix)]
mod watch_screen;
