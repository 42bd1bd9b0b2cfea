//! The hints: first where to look, then what to think about, and last what to read. Each press of a
//! key shows one more.

use super::order::Item;
use super::state::State;
use pinhole_course::describe::NOTE;
use pinhole_course::diagnosis::Diagnosis;
use pinhole_course::mistake::Mistake;
use pinhole_course::outcome::{AnswerFile, TaskOutcome};
use pinhole_report::passage::Passage;
use pinhole_report::terminal::note;

/// The hints for what is shown, each stronger than the one before. Empty if nothing is wrong.
pub fn of(state: &State) -> Vec<String> {
    match state.item() {
        Some(Item::Task(_)) => state
            .item()
            .and_then(|item| state.task(item))
            .map_or(Vec::new(), on_task),
        Some(Item::Scenes) => on_scenes(state),
        None => Vec::new(),
    }
}

fn on_task(task: &TaskOutcome) -> Vec<String> {
    let Some(failing) = task.groups.iter().find(|group| !group.outcome.passes()) else {
        return Vec::new();
    };
    if !task.diagnosis.is_empty() {
        return known(&task.diagnosis);
    }
    let read = format!("read: {}", Passage::chapter(&task.chapter));
    if task.file != AnswerFile::Compiled {
        let look = "look: read the compiler's first message, because the others may follow from it";
        return vec![look.into(), read];
    }
    if task.is_unanswered() {
        let look = "look: the comment above the function says what comes in and what goes out";
        return vec![look.into(), read];
    }
    let notes = failing.worst.iter().filter(|fact| fact.label == NOTE);
    let notes = notes.map(|fact| format!("note: {}", fact.text));
    let look = format!("look: `{}` asks about {}", failing.name, failing.about);
    let think = "think: work through the question above with a pencil; which step is the first \
                 whose result you did not expect?";
    notes.chain([look, think.into(), read]).collect()
}

fn on_scenes(state: &State) -> Vec<String> {
    let scenes = state.known.outcome.scenes.iter().zip(&state.known.films);
    let mut failing = scenes.filter(|(scene, _)| !scene.outcome.passes());
    match failing.next() {
        None => Vec::new(),
        Some((scene, _)) if !scene.diagnosis.is_empty() => known(&scene.diagnosis),
        Some((_, film)) => {
            let look = "look: `explain` shows what each of your answers returns for one pixel";
            let think = "think: which answer is the first whose result you did not expect?";
            let note = note(film).into_iter();
            note.chain([look.into(), think.into()]).collect()
        }
    }
}

/// The hints of the mistakes behind a diagnosis, level by level.
fn known(diagnosis: &Diagnosis) -> Vec<String> {
    let beliefs = diagnosis.beliefs.iter().map(|belief| &belief.mistake);
    let depth = |tell: fn(&Mistake) -> String| {
        let told: Vec<String> = beliefs.clone().map(tell).collect();
        told.join("\n")
    };
    vec![
        depth(|mistake| format!("look: {}", mistake.hint.look)),
        depth(|mistake| format!("think: {}", mistake.hint.think)),
        depth(|mistake| {
            let Mistake { chapter, hint, .. } = mistake;
            let example = hint.example.iter().map(|it| format!("example: {it}\n"));
            let read = Passage::section(chapter, &hint.read);
            format!("{}read: {read}", example.collect::<String>())
        }),
    ]
}
