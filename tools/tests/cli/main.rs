//! The real command on the real course: real Mitsuba, oiiotool, compiler, sandbox.

mod browser;
mod check;
mod course;
mod diagnosis;
mod diff;
mod explain;
mod golden;
mod grade;
mod house;
mod report;
mod sandbox;
mod submissions;
mod watch;
#[cfg(unix)]
mod watch_screen;
