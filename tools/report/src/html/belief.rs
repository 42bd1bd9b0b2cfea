//! A diagnosis in words for students, with a link to the book.

use serde::Serialize;

use crate::passage::Passage;
use crate::terminal::{share, share_of_what};
use pinhole_course::diagnosis::{Diagnosis, Explanation, Reading};

/// A belief that explains wrong answers, with hints.
#[derive(Debug, PartialEq, Serialize)]
pub struct Beliefs {
    /// How several beliefs belong together; none for a single belief.
    pub reading: Option<String>,
    /// The beliefs, each with its hints.
    pub beliefs: Vec<Belief>,
}

/// One belief and its hints.
#[derive(Debug, PartialEq, Serialize)]
pub struct Belief {
    /// The section that has already explained it.
    pub told: Option<BeliefReference>,
    pub belief: String,
    /// The share that it explains; none if the student holds only one of several.
    pub explains: Option<String>,
    /// How many others held it; none if there were no others.
    pub company: Option<u32>,
    pub look: String,
    pub think: String,
    pub example: Option<String>,
    pub read: Passage,
}

/// A belief that a task's section explains.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BeliefReference {
    slug: String,
    task: String,
    id: String,
}

impl Beliefs {
    /// `None` if no belief is named. A belief in `told` gets only a reference to the earlier
    /// section that explains it.
    pub fn of(diagnosis: &Diagnosis, told: &[BeliefReference]) -> Option<Beliefs> {
        let one_of = diagnosis.reading == Reading::OneOf && diagnosis.beliefs.len() > 1;
        let most = diagnosis.beliefs.iter().map(|held| held.explained);
        let reading = one_of.then(|| {
            let share = share_of_what(most.fold(0.0, f64::max));
            format!("One of these beliefs explains {share} is wrong here, but the answers don't show which:")
        });
        let belief = |held: &Explanation| {
            let mistake = &held.mistake;
            Belief {
                told: told.iter().find(|told| told.slug == held.slug).cloned(),
                belief: mistake.belief.clone(),
                explains: (!one_of).then(|| share(held.explained, diagnosis)),
                company: mistake.submissions.filter(|count| *count > 1),
                look: mistake.hint.look.clone(),
                think: mistake.hint.think.clone(),
                example: mistake.hint.example.clone(),
                read: Passage::section(&mistake.chapter, &mistake.hint.read),
            }
        };
        (!diagnosis.is_empty()).then(|| Beliefs {
            reading,
            beliefs: diagnosis.beliefs.iter().map(belief).collect(),
        })
    }
}

impl BeliefReference {
    /// The beliefs that the section of the `k`-th task explains.
    pub fn by_task<'a>(
        k: usize,
        name: &'a str,
        diagnosis: &'a Diagnosis,
    ) -> impl Iterator<Item = BeliefReference> + 'a {
        diagnosis.beliefs.iter().map(move |held| BeliefReference {
            slug: held.slug.clone(),
            task: name.into(),
            id: format!("task-{k}"),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::html::testing::belief;

    fn diagnosis(beliefs: Vec<Explanation>, reading: Reading) -> Diagnosis {
        Diagnosis { beliefs, reading }
    }

    #[test]
    fn a_single_belief_says_how_much_it_explains() {
        let single = diagnosis(vec![belief("I subtract ½.", 0.981)], Reading::Together);
        let beliefs = Beliefs::of(&single, &[]).expect("there is one");
        assert_eq!(beliefs.reading, None);
        assert_eq!(beliefs.beliefs[0].explains.as_deref(), Some("98 % of what"));
        assert_eq!(beliefs.beliefs[0].told, None);
    }

    #[test]
    fn beliefs_that_cannot_be_told_apart_are_one_sentence() {
        let either = diagnosis(vec![belief("A.", 1.0), belief("B.", 1.0)], Reading::OneOf);
        let beliefs = Beliefs::of(&either, &[]).expect("there are two");
        let reading = beliefs.reading.expect("they are one of two");
        assert!(reading.contains("explains all that is wrong"), "{reading}");
        assert!(
            beliefs
                .beliefs
                .iter()
                .all(|belief| belief.explains.is_none())
        );
    }

    #[test]
    fn belief_explained_in_a_task_is_not_repeated() {
        let single = diagnosis(vec![belief("A.", 1.0)], Reading::Together);
        let told: Vec<BeliefReference> = BeliefReference::by_task(2, "sphere", &single).collect();
        let beliefs = Beliefs::of(&single, &told).expect("there is one");
        assert_eq!(
            beliefs.beliefs[0]
                .told
                .as_ref()
                .map(|told| told.id.as_str()),
            Some("task-2")
        );
    }

    #[test]
    fn without_a_diagnosis_nothing_is_named() {
        assert_eq!(Beliefs::of(&Diagnosis::default(), &[]), None);
    }
}
