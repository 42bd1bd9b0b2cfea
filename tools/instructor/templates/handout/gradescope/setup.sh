#!/usr/bin/env bash
# Gradescope runs this once, as root and with a network, when it builds the container's
# image. The whole class is then graded by one compiler and one build.
set -euo pipefail

apt-get update
apt-get install -y --no-install-recommends ca-certificates curl gcc libc6-dev

# Don't use root's home, because students' code runs as another user and could not reach it.
export RUSTUP_HOME=/opt/rust/rustup CARGO_HOME=/opt/rust/cargo
mkdir -p /opt/rust
curl --proto '=https' --tlsv1.2 -sSf https://sh.rustup.rs |
    sh -s -- -y --profile minimal --no-modify-path
chmod -R a+rX /opt/rust

cd /autograder/source/pinhole
/opt/rust/cargo/bin/cargo build --release -p pinhole -p pinhole-cli -p pinhole-instructor

# Only the grader may read this. The libraries for submissions are copied to another folder.
chmod 700 .
