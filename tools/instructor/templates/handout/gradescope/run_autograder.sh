#!/usr/bin/env bash
# Gradescope runs this for each submission, as root, in a container that is used once.
set -uo pipefail

export RUSTUP_HOME=/opt/rust/rustup CARGO_HOME=/opt/rust/cargo CARGO_NET_OFFLINE=true
export PATH="/opt/rust/cargo/bin:$PATH"
cd /autograder/source/pinhole || exit

# The student's code runs in this container as another user, who must not read the results.
graded=/autograder/graded
rm -rf "$graded"
mkdir -m 700 "$graded"

# Grade a folder that contains the submission, not the submission itself. Then even a submission
# without answer files is graded, and the student sees which files are missing.
class=/autograder/class
rm -rf "$class"
mkdir -m 700 "$class"
cp -a /autograder/submission "$class/submission"

# Nobody else may replace the folder of fresh questions.
chown root:root /autograder /autograder/source
chmod go-w /autograder /autograder/source
fresh=(--no-fresh)
if [ -d fresh ]; then fresh=(--fresh fresh); fi
target/release/pinhole-instructor grade "$class" --out "$graded" \
    --sandbox container --format gradescope --reveal "$(cat reveal)" "${fresh[@]}"

results=/autograder/results/results.json
if ! cp "$graded"/submissions/*/gradescope.json "$results"; then
    # Give no score, because a fault of the grader must not become a student's zero.
    echo '{"output": "The grader failed, not your answers. Your instructor can run it again.", "stdout_visibility": "hidden"}' >"$results"
fi
