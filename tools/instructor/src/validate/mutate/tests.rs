use super::*;

/// The changed lines of all mutants of an answer with this body.
#[track_caller]
fn changes(body: &str) -> Vec<String> {
    let text = format!(
        "fn outside(x: f64) -> f64 {{ x + 1.0 }}\n\
         fn answer(&self, ray: &Ray, min_t: f64) -> Option<f64> {{\n    // ANCHOR: answer\n    \
         {body}\n    // ANCHOR_END: answer\n}}\n"
    );
    let mutants = mutants("answer", &text).expect("it is Rust");
    assert!(
        mutants
            .iter()
            .all(|mutant| syn::parse_file(&mutant.text).is_ok())
    );
    mutants.into_iter().map(|mutant| mutant.becomes).collect()
}

#[track_caller]
fn holds(body: &str, expected: &[&str]) {
    let found = changes(body);
    for change in expected {
        assert!(
            found.iter().any(|found| found == change),
            "no {change:?} in {found:#?}"
        );
    }
}

#[test]
fn offutts_five_operators_are_there() {
    holds(
        "let h = a * b - c; (h < min_t && -h > 1.0).then(|| h)",
        &[
            // ABS
            "let h = (a * b - c).abs(); (h < min_t && -h > 1.0).then(|| h)",
            // AOR
            "let h = (a / b) - c; (h < min_t && -h > 1.0).then(|| h)",
            // LCR
            "let h = a * b - c; (h < min_t || -h > 1.0).then(|| h)",
            // ROR
            "let h = a * b - c; (h <= min_t && -h > 1.0).then(|| h)",
            // UOI, and a sign left out
            "let h = -(a * b - c); (h < min_t && -h > 1.0).then(|| h)",
            "let h = a * b - c; (h < min_t && h > 1.0).then(|| h)",
        ],
    );
}

#[test]
fn another_operator_does_not_change_what_binds_first() {
    holds(
        "Some(a - b * c)",
        &["Some(a - (b + c))", "Some(a * (b * c))"],
    );
    holds(
        "Some(a + b - c)",
        &["Some((a * b) - c)", "Some((a + b) / c)"],
    );
}

#[test]
fn neighbouring_fields_are_swapped() {
    holds(
        "Some(camera.width * camera.u)",
        &[
            "Some(camera.height * camera.u)",
            "Some(camera.width * camera.w)",
        ],
    );
    holds("Some(t1.cross(t2))", &["Some(t2.cross(t1))"]);
    holds("Some(d.length_squared())", &["Some(d.length())", "Some(d)"]);
    holds(
        "list.iter().min_by(f)",
        &["list.iter().max_by(f)", "list.iter().skip(1).min_by(f)"],
    );
    holds(
        "ask(ray, min_t)",
        &["ask(ray, 0.0)", "ask(ray, 1.0)", "None"],
    );
    holds(
        "let near = 1.0; let far = 2.0; [near, far]",
        &[
            "let near = 1.0; let far = 2.0; [far, near]",
            "let near = 1.0; let far = 2.0; [far, far]",
        ],
    );
}

#[test]
fn nothing_outside_the_answer_is_changed_and_no_mutant_is_written_twice() {
    let found = changes("Some(min_t + 0.5)");
    assert!(
        found.iter().all(|change| !change.contains("x + 1.0")),
        "{found:#?}"
    );
    let distinct: BTreeSet<&String> = found.iter().collect();
    assert_eq!(distinct.len(), found.len());
}

#[test]
fn a_mutant_says_where_it_differs_and_how() {
    let text =
        "// ½\nfn f() -> f64 {\n    // ANCHOR: answer\n    ½(0.5)\n    // ANCHOR_END: answer\n}\n";
    let text = text.replace("½(", "half(");
    let mutants = mutants("sphere", &text).expect("it is Rust");
    let mutant = mutants.first().expect("there is a mutant of 0.5");
    assert_eq!(mutant.name(), "sphere.rs:4:10");
    assert_eq!(mutant.diff(), "  - half(0.5)\n  + half(0.0)");
    assert!(mutant.text.contains("// ½\n"));
}
