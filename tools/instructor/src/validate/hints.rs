//! Checks that the hints of known mistakes are short and easy to read, and have an example in
//! numbers.

use pinhole_course::mistake::{Hint, MistakeFolder};

/// How many words the three depths may have together.
const MOST_WORDS: usize = 160;

/// The highest Flesch–Kincaid grade of a hint.
const HIGHEST_GRADE: f64 = 9.0;

/// What is wrong with the hints of these mistakes.
pub fn faults(mistakes: &[MistakeFolder]) -> Vec<String> {
    let of_one = |found: &MistakeFolder| {
        let name = format!("mistakes/{}", found.slug);
        // No diagnosis names a combined mistake, so nobody reads its hint.
        let needs_example = found.mistake.is_single();
        let faults = faults_of(&found.mistake.hint, needs_example).into_iter();
        faults.map(move |fault| format!("{name}: {fault}"))
    };
    mistakes.iter().flat_map(of_one).collect()
}

/// What is wrong with a hint.
pub fn faults_of(hint: &Hint, needs_example: bool) -> Vec<String> {
    let example = hint.example.as_deref().unwrap_or_default();
    let depths = [&hint.look, &hint.think, example, &hint.read];
    let words: usize = depths.iter().map(|it| it.split_whitespace().count()).sum();
    let grade = pinhole_reading::grade(&depths).unwrap_or_default();
    let mut faults = Vec::new();
    if words > MOST_WORDS {
        faults.push(format!(
            "its hint has {words} words; write at most {MOST_WORDS}"
        ));
    }
    if grade > HIGHEST_GRADE {
        faults.push(format!(
            "its hint has reading grade {grade:.1}, above {HIGHEST_GRADE}; write shorter \
             sentences and shorter words"
        ));
    }
    if needs_example && !example.contains(|c: char| c.is_ascii_digit()) {
        faults.push("`hint.example` has no number; write a small case in numbers there".into());
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hint(look: &str, example: Option<&str>) -> Hint {
        Hint {
            look: look.into(),
            think: "Which root counts?".into(),
            example: example.map(str::to_owned),
            read: "The roots".into(),
        }
    }

    #[test]
    fn a_good_hint_has_no_fault() {
        let good = hint("Look at the rim.", Some("The roots are 4 and 6."));
        assert_eq!(faults_of(&good, true), Vec::<String>::new());
    }

    #[test]
    fn long_hard_or_vague_hints_are_faults() {
        let long = hint(&"Look at the rim. ".repeat(40), Some("t is 4."));
        assert_eq!(
            faults_of(&long, true).len(),
            1,
            "{:?}",
            faults_of(&long, true)
        );
        let hard = hint(
            "Numerically unstable discriminants invalidate intersections whenever cancellation \
             eliminates significant digits of intermediate quantities.",
            Some("t is 4."),
        );
        let faults = faults_of(&hard, true);
        assert!(
            faults.len() == 1 && faults[0].contains("grade"),
            "{faults:?}"
        );
        for vague in [None, Some("It depends.")] {
            assert_eq!(faults_of(&hint("Look.", vague), true).len(), 1);
        }
        assert_eq!(faults_of(&hint("Look.", None), false).len(), 0);
    }
}
