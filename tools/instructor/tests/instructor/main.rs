//! The real program on the real course: real Mitsuba, oiiotool, compiler, sandbox.

mod diagnosis;
mod examples;
mod fixture;
mod golden;
mod grade;
mod handout;
mod house;
mod submissions;
mod validate;
