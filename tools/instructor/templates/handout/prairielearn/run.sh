#!/usr/bin/env bash
# PrairieLearn runs this for each submission, as root, in a container that is used once.
set -uo pipefail

mkdir -p /grade/results
cd /opt/pinhole || exit
graded=/opt/graded class=/opt/class
mkdir -m 700 "$graded" "$class"
# Grade a folder that contains the submission, not the submission itself. Then even a submission
# without answer files is graded, and the student sees which files are missing.
cp -a /grade/student "$class/submission"

fresh=(--no-fresh)
if [ -d fresh ]; then fresh=(--fresh fresh); fi
target/release/pinhole-instructor grade "$class" --out "$graded" \
    --sandbox container --format prairielearn --reveal "$(cat reveal)" "${fresh[@]}"

if ! cp "$graded"/submissions/*/prairielearn.json /grade/results/results.json; then
    # Call it not gradable, so that a fault of the grader costs no attempt and does not count as a
    # zero.
    echo '{"gradable": false, "format_errors": "The grader failed, not your answers. Your instructor can run it again."}' >/grade/results/results.json
fi
