#!/usr/bin/env bash
# Gradescope runs this for each submission, as root, in a container that is used once.
set -uo pipefail

export RUSTUP_HOME=/opt/rust/rustup CARGO_HOME=/opt/rust/cargo CARGO_NET_OFFLINE=true
export PATH="/opt/rust/cargo/bin:$PATH"
cd /autograder/source/pinhole

# Another user's code runs in this container: what is graded is root's alone.
graded=/autograder/graded
rm -rf "$graded"
mkdir -m 700 "$graded"

fresh=(--no-fresh)
if [ -d fresh ]; then fresh=(--fresh fresh); fi
target/release/pinhole grade /autograder/submission --out "$graded" \
    --sandbox container --format gradescope "${fresh[@]}"
code=$?

results=/autograder/results/results.json
graded=("$graded"/submissions/*/gradescope.json)
if [ -f "${graded[0]}" ]; then
    cp "${graded[0]}" "$results"
elif [ "$code" = 2 ]; then
    echo '{"score": 0, "output": "There was nothing to grade: upload the six answer files, or a zip of them."}' >"$results"
else
    # Without a score: a fault of the grader is no student's zero.
    echo '{"output": "The grader failed, not your answers. Your instructor can run it again.", "stdout_visibility": "hidden"}' >"$results"
fi
