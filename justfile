# The three checks that CONTRIBUTING.md explains. They are scripts, so `just` is not needed.

# Formatting and unit tests. Needs only Rust, and takes 15 seconds once the tests are compiled.
quick:
    .ci/quick

# Every test, with the real Mitsuba, sandbox and browser.
test:
    tools/test

# Everything that CI runs.
all:
    .ci/run
