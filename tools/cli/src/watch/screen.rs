//! The screen: a verdict, and below it the student's progress and the keys.

use textwrap::{Options, WordSplitter};

use super::hints;
use super::keys::KEYS;
use super::order::Item;
use super::state::State;
use pinhole_course::outcome::TaskOutcome;
use pinhole_report::escape::printable;
use pinhole_report::terminal::{self, FAIL, PASS, QUIET, STRONG};

/// A screenful.
pub struct Frame {
    /// The lines: as many as fit on the screen, and none wider than it.
    pub lines: Vec<String>,
    /// How many lines it is scrolled: as far as the user asked, or as far as possible.
    pub scroll: usize,
}

/// Columns of the picture at the end.
const PICTURE_COLUMNS: usize = 48;

/// Columns of the progress bar.
const WIDEST_BAR: usize = 40;

/// The screen for a terminal of this size.
pub fn frame(state: &State, columns: usize, rows: usize) -> Frame {
    let mut foot = fold(&foot(state, columns), columns);
    foot.truncate(rows.saturating_sub(3).max(1));
    let body = fold(&body(state), columns);
    let room = rows.saturating_sub(foot.len() + 1);
    let scroll = state.scroll.min(body.len().saturating_sub(room));
    let below = body.len().saturating_sub(scroll + room);
    let mut lines: Vec<String> = body.into_iter().skip(scroll).take(room).collect();
    lines.resize(room, String::new());
    // A blank line between verdict and foot, or an arrow with the number of lines beyond the
    // screen.
    lines.push(match (scroll, below) {
        (_, 1..) => cut(format!("{QUIET}↓ {below} more{QUIET:#}"), columns),
        (1.., _) => cut(format!("{QUIET}↑ {scroll} more{QUIET:#}"), columns),
        _ => String::new(),
    });
    lines.extend(foot);
    lines.truncate(rows);
    Frame { lines, scroll }
}

fn body(state: &State) -> String {
    if state.help {
        let keys = KEYS
            .iter()
            .map(|(key, _, _, help)| format!("  {STRONG}{key}{STRONG:#}  {help}"));
        let keys = keys.collect::<Vec<_>>().join("\n");
        return format!(
            "Each answer is judged when you save it.\n\n{keys}\n  {STRONG}↑ ↓{STRONG:#}  scroll\n"
        );
    }
    if let Some(problem) = &state.problem {
        let lines: Vec<String> = problem.problem.lines().map(printable).collect();
        let text = lines.join("\n");
        let remedy = printable(&problem.remedy);
        return format!("{FAIL}{text}{FAIL:#}\n  remedy: {remedy}\n");
    }
    let mut text = match state.item() {
        None => terminal::examination(&state.known),
        Some(item) if !state.has_verdict(item) => {
            format!("{STRONG}{}{STRONG:#}\n", item.name())
        }
        Some(Item::Scenes) => terminal::scenes(&state.known).trim_start().into(),
        Some(item) => {
            let width = item.name().len() + 2;
            let told = state.task(item).map(|task| terminal::task(task, width));
            told.unwrap_or_default()
        }
    };
    if let Some(item) = state.item() {
        text.push_str(&terminal::printed(state.printed(item)));
    }
    if let (Some(Item::Scenes) | None, Some(finish)) = (state.item(), state.finish()) {
        let picture = terminal::shows_pictures().then(|| finish.in_blocks(PICTURE_COLUMNS));
        let words = finish.words();
        text = format!(
            "{}\n{STRONG}{words}{STRONG:#}\n{text}",
            picture.unwrap_or_default()
        );
    }
    for hint in hints::of(state).iter().take(state.hints) {
        text.push_str(&format!("\n{hint}\n"));
    }
    text
}

/// The last event, the student's progress, which file to edit, and the keys.
fn foot(state: &State, columns: usize) -> String {
    let keys = KEYS.iter().map(|(key, _, name, _)| {
        // A space at which no line breaks.
        format!("{STRONG}{key}{STRONG:#}:{}", name.replace(' ', "\u{a0}"))
    });
    let file = match state.item() {
        Some(Item::Task(name)) => {
            let mut tasks = state.known.outcome.tasks.iter();
            let line = tasks
                .find(|task| task.name == *name)
                .and_then(TaskOutcome::line);
            let place = state
                .submission
                .place_to_edit(name, line)
                .unwrap_or_default();
            format!("{QUIET}edit {}{QUIET:#}\n", printable(&place))
        }
        _ => String::new(),
    };
    format!(
        "{}\n{}\n{}\n{file}{}",
        happened(state),
        list(state),
        progress(state, columns),
        keys.collect::<Vec<_>>().join("  ")
    )
}

/// Every task with its state, the current one in bold: "✓ plane  ✗ sphere  … triangle".
fn list(state: &State) -> String {
    let item = |item: &Item| {
        let (style, mark) = match (state.has_verdict(item), state.is_full(item)) {
            (true, true) => (PASS, "✓"),
            (true, false) if state.is_open(item) => (QUIET, "·"),
            (true, false) => (FAIL, "✗"),
            (false, _) => (QUIET, "…"),
        };
        // Don't break a line between a mark and its name.
        let name = match state.item() == Some(item) {
            true => format!("{STRONG}{}{STRONG:#}", item.name()),
            false => item.name().to_owned(),
        };
        format!("{style}{mark}{style:#}\u{a0}{name}")
    };
    let items: Vec<String> = state.items.iter().map(item).collect();
    items.join("  ")
}

fn happened(state: &State) -> String {
    let judged = match state.item() {
        Some(item) if state.has_verdict(item) => state.after_save(item).map(|after| {
            let next = match state.is_full(item) {
                true => "; press n to go on",
                false => "",
            };
            format!("judged {:.2} s after you saved{next}", after.as_secs_f64())
        }),
        Some(item) => Some(format!("judging {} …", item.name())),
        None if state.is_judging() => Some("judging everything …".into()),
        None => None,
    };
    let all: Vec<String> = judged.into_iter().chain(state.notice.clone()).collect();
    all.join("; ")
}

/// "[####--------] 2 / 6 tasks, 51 / 80 points", or scenes if they are shown.
fn progress(state: &State, columns: usize) -> String {
    let (full, count, what) = match state.item() {
        Some(Item::Scenes) => {
            let scenes = &state.known.outcome.scenes;
            let passing = scenes.iter().filter(|scene| scene.outcome.passes());
            (passing.count(), state.scenes, "scenes")
        }
        _ => {
            let tasks = state.items.iter().filter(|item| **item != Item::Scenes);
            let full = tasks.clone().filter(|task| state.is_full(task));
            (full.count(), tasks.count(), "tasks")
        }
    };
    let (points, possible) = state.points();
    let said = format!("{full} / {count} {what}, {points} / {possible} points");
    let width = columns.saturating_sub(said.len() + 3).min(WIDEST_BAR);
    let done = (width * full).checked_div(count).unwrap_or(0);
    let (done, left) = ("#".repeat(done), "-".repeat(width - done));
    format!("[{PASS}{done}{PASS:#}{left}] {said}")
}

/// Breaks lines that are wider than the screen, and keeps their indentation.
fn fold(text: &str, columns: usize) -> Vec<String> {
    let mut lines = Vec::new();
    for line in text.lines() {
        let indent = line.len() - line.trim_start().len();
        let indent = " ".repeat((indent + 2).min(columns / 3));
        let options = Options::new(columns.max(8))
            .subsequent_indent(&indent)
            .word_splitter(WordSplitter::NoHyphenation);
        let folded = textwrap::wrap(line, options);
        lines.extend(folded.into_iter().map(String::from));
    }
    lines
}

fn cut(line: String, columns: usize) -> String {
    fold(&line, columns).swap_remove(0)
}

#[cfg(test)]
mod tests;
