//! The table of keys: what each does, and how the screen describes it.

use std::sync::mpsc::Sender;
use std::thread;

use crossterm::event::{self, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

use super::Event;

/// What a key does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Key {
    Hint,
    Report,
    Next,
    Previous,
    Everything,
    Scenes,
    RepeatCommands,
    Quit,
    Help,
    /// Scroll down by this many lines, or up if negative.
    Scroll(isize),
}

/// Letter, meaning, its name on the screen, and its description in the help.
pub const KEYS: [(char, Key, &str, &str); 9] = [
    (
        'h',
        Key::Hint,
        "hint",
        "show a hint; each press shows one more",
    ),
    (
        'o',
        Key::Report,
        "report",
        "open the report once everything is judged",
    ),
    ('n', Key::Next, "next", "go to the next task"),
    ('p', Key::Previous, "previous", "go to the previous task"),
    (
        'a',
        Key::Everything,
        "all",
        "judge everything, and show a table",
    ),
    (
        's',
        Key::Scenes,
        "scenes",
        "render the scenes with all your answers",
    ),
    ('r', Key::RepeatCommands, "again", "judge this again"),
    ('q', Key::Quit, "quit", "quit (or press Ctrl-C)"),
    ('?', Key::Help, "help", "show or hide this help"),
];

/// Nearly a screen, so that some lines stay visible.
const PAGE: isize = 10;

/// Reports every key and change of size. Runs on a separate thread.
pub fn listen(events: Sender<Event>) {
    thread::spawn(move || {
        loop {
            let event = match event::read() {
                Ok(event::Event::Key(pressed)) => key(pressed).map(Event::Key),
                Ok(event::Event::Resize(..)) => Some(Event::Resized),
                Ok(_) => None,
                // This happens when the terminal is gone.
                Err(_) => Some(Event::Quit),
            };
            let over = matches!(event, Some(Event::Quit));
            let sent = event.is_none_or(|event| events.send(event).is_ok());
            if over || !sent {
                break;
            }
        }
    });
}

fn key(pressed: KeyEvent) -> Option<Key> {
    if pressed.kind == KeyEventKind::Release {
        return None;
    }
    match pressed.code {
        KeyCode::Char('c' | 'd') if pressed.modifiers.contains(KeyModifiers::CONTROL) => {
            Some(Key::Quit)
        }
        KeyCode::Char(letter) => {
            let letter = letter.to_ascii_lowercase();
            let known = KEYS.iter().find(|(known, ..)| *known == letter);
            known.map(|(_, key, ..)| *key)
        }
        KeyCode::Down => Some(Key::Scroll(1)),
        KeyCode::Up => Some(Key::Scroll(-1)),
        KeyCode::PageDown => Some(Key::Scroll(PAGE)),
        KeyCode::PageUp => Some(Key::Scroll(-PAGE)),
        _ => None,
    }
}
