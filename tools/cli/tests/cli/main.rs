//! The real command on the real course: real oiiotool, compiler, sandbox, browser.

mod browser;
mod check;
#[cfg(target_os = "linux")]
mod container;
mod diff;
mod doctor;
mod examples;
mod explain;
#[cfg(target_os = "linux")]
mod hostile;
#[cfg(target_os = "linux")]
mod modes;
mod patience;
mod report;
mod sandbox;
mod version;
mod watch;
#[cfg(unix)]
mod watch_screen;
