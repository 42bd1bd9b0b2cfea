//! `--version` and `completions`.

use pinhole_testing::pinhole;

#[test]
fn the_version_names_the_commit_and_the_goldens() {
    let ran = pinhole(&["--version"]).expect_code(0);
    let lines: Vec<&str> = ran.out.lines().collect();
    let starts = [
        "pinhole ",
        "commit ",
        "goldens bounding_volumes ",
        "goldens ray_casting ",
    ];
    assert_eq!(lines.len(), starts.len(), "{}", ran.out);
    for (line, start) in lines.iter().zip(starts) {
        let rest = line.strip_prefix(start).expect(line);
        assert!(rest.len() >= 5 && !rest.contains(' '), "{line}");
    }
}

#[test]
fn completions_know_options_and_the_other_programs_subcommands() {
    let script = pinhole(&["completions", "bash"]).expect_code(0).out;
    for word in ["--oiiotool", "explain", "validate", "study"] {
        assert!(script.contains(word), "no {word}");
    }
}
