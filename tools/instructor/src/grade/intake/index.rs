//! Finds who may be meant by a name, without comparing it with everyone on a long roster.

use std::collections::{BTreeSet, HashMap};

use super::matching::{spellings, without_accents, words};
use super::roster::Person;

/// People by the words that stand for them.
#[derive(Default)]
pub struct Index<'a> {
    people: &'a [Person],
    by_word: HashMap<String, Vec<usize>>,
}

impl<'a> Index<'a> {
    /// Files everyone under each of their ids and logins, their name and their group: under the word
    /// of it that the fewest people have, and under all its words together.
    pub fn of(people: &'a [Person]) -> Index<'a> {
        let mut frequency: HashMap<String, usize> = HashMap::new();
        let all = people.iter().flat_map(texts);
        for word in all.flat_map(|text| both_words(&text)).flatten() {
            *frequency.entry(word).or_default() += 1;
        }
        let mut by_word: HashMap<String, Vec<usize>> = HashMap::new();
        for (at, person) in people.iter().enumerate() {
            let of = |text: String| {
                let rarest = |words: Vec<String>| words.into_iter().min_by_key(|it| frequency[it]);
                let together = words(&text).concat();
                let rarest = both_words(&text).into_iter().filter_map(rarest);
                rarest.chain([together]).collect::<Vec<_>>()
            };
            let all = texts(person).flat_map(of).chain(spellings(&person.name));
            for word in all.collect::<BTreeSet<_>>() {
                by_word.entry(word).or_default().push(at);
            }
        }
        Index { people, by_word }
    }

    /// The people who share such a word with a text, in the order of the roster. Among other words,
    /// a name whose words are divided in another way is overlooked, such as `adalove-lace`.
    pub fn near(&self, text: &str) -> Vec<&'a Person> {
        let words = [words_of(text), words_of(&without_accents(text))].concat();
        let found = words.iter().filter_map(|word| self.by_word.get(word));
        let found: BTreeSet<usize> = found.flatten().copied().collect();
        found.into_iter().map(|at| &self.people[at]).collect()
    }
}

/// What stands for a person, with and without accents.
fn texts(person: &Person) -> impl Iterator<Item = String> {
    let locals = person.logins.iter().filter_map(|it| it.split_once('@'));
    let locals = locals.map(|(local, _)| local);
    let own = person
        .logins
        .iter()
        .chain(&person.github)
        .chain(&person.group);
    let own = own.chain([&person.id, &person.name]).map(String::as_str);
    own.chain(locals)
        .flat_map(|text| [text.to_owned(), without_accents(text)])
}

/// The words of a text, if punctuation ends a word, and if it does not.
fn both_words(text: &str) -> [Vec<String>; 2] {
    let spaced = text.split_whitespace().map(|word| words(word).concat());
    [
        words(text),
        spaced.filter(|word| !word.is_empty()).collect(),
    ]
}

/// The words of a text, and all of them together but for some at its beginning or at its end, which
/// may be a title.
fn words_of(text: &str) -> Vec<String> {
    // In an archive, a name may have thousands of words. No title is so long.
    const MOST: usize = 32;
    let words = words(text);
    let few = 0..words.len().min(MOST);
    let ends = few.clone().map(|at| words[at..].concat());
    let begins = few.map(|at| words[..words.len() - at].concat());
    let together: Vec<String> = ends.chain(begins).collect();
    words.into_iter().chain(together).collect()
}
