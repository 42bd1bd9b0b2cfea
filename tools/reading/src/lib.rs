//! How hard a text is to read: the Flesch–Kincaid grade (Kincaid, Fishburne, Rogers &
//! Chissom 1975), which is about the number of years of school that it takes.
//!
//! ```
//! let grade = pinhole_reading::grade(&["The ray hits the red ball."]).expect("it has a sentence");
//! assert!(grade < 1.0);
//! ```

/// The grade of paragraphs; `None` if they have no words.
pub fn grade<T: AsRef<str>>(paragraphs: &[T]) -> Option<f64> {
    let (mut sentences, mut words, mut syllables) = (0, 0, 0);
    for paragraph in paragraphs {
        let mut begun = false;
        for word in paragraph.as_ref().split_whitespace() {
            if word.chars().any(char::is_alphabetic) {
                begun = true;
                words += 1;
                syllables += syllables_of(word);
            }
            // Look only at the end of a word, because the point in 1.5 ends no sentence.
            let bare = word.trim_end_matches([')', '”', '"']);
            if begun && bare.ends_with(['.', '?', '!', ':', ';']) {
                begun = false;
                sentences += 1;
            }
        }
        sentences += usize::from(begun);
    }
    let share = |part: usize, whole: usize| part as f64 / whole as f64;
    (sentences > 0).then(|| 0.39 * share(words, sentences) + 11.8 * share(syllables, words) - 15.59)
}

/// Counts groups of vowels, ignoring a silent e at the end. Returns at least 1.
fn syllables_of(word: &str) -> usize {
    let letters: Vec<char> = word
        .to_lowercase()
        .chars()
        .filter(|c| c.is_alphabetic())
        .collect();
    let vowel = |at: usize| "aeiouyé".contains(letters[at]);
    let begins = |at: &usize| vowel(*at) && (*at == 0 || !vowel(*at - 1));
    let groups = (0..letters.len()).filter(begins).count();
    let silent = matches!(letters.as_slice(), [.., before, 'e'] if !"aeiouyl".contains(*before));
    (groups - usize::from(silent && groups > 1)).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> f64 {
        grade(&[text]).expect("it has a sentence")
    }

    #[test]
    fn syllables_are_counted_as_they_are_spoken() {
        let words = [
            ("ray", 1),
            ("plane", 1),
            ("table", 2),
            ("camera", 3),
            ("the", 1),
            ("e", 1),
        ];
        for (word, count) in words {
            assert_eq!(syllables_of(word), count, "{word}");
        }
    }

    #[test]
    fn long_words_in_long_sentences_are_harder() {
        // 6 words in one sentence, 6 syllables.
        assert!((of("The ray hits the red ball.") - (0.39 * 6.0 + 11.8 - 15.59)).abs() < 1e-12);
        let hard = "Numerically unstable discriminants invalidate intersections whenever cancellation \
                    eliminates significant digits of intermediate quantities.";
        assert!(of(hard) > 20.0);
        assert_eq!(of("It is 1.5 high."), of("It is high."));
        assert_eq!(grade(&[""]), None);
    }
}
