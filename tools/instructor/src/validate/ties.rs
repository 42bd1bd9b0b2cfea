//! Questions of which many are exact ties, drawn by the assignment's Python.
//!
//! A tie is a question whose answer depends on comparing two equal numbers: t exactly `min_t`, a
//! ray exactly through an edge, two objects at the same t. Goldens in 32-bit floats cannot judge
//! ties, so they contain none.

use pinhole::Film;
use pinhole::kind::Questions;

use pinhole_course::assignment::Task;
use pinhole_course::error::{Error, Result};
use pinhole_course::goldens::Goldens;

/// The questions of a task's tie film, and which of them are ties; `None` if there is no
/// such film.
pub fn read(goldens: &Goldens, task: &Task) -> Result<Option<(Questions, Vec<bool>)>> {
    let name = format!("ties/{}.ask.exr", task.name);
    let path = goldens.folder.join(name);
    if !path.is_file() {
        return Ok(None);
    }
    let (questions, _) = Questions::read(&path, &task.name, task.kind, task.shape)?;
    let film = Film::read(&path)?;
    let Some(ties) = film.channel("tie") else {
        return Err(Error::environment(
            format!("{} has no channel `tie`", path.display()),
            "restore the goldens: git checkout -- golden",
        ));
    };
    Ok(Some((
        questions,
        ties.iter().map(|tie| *tie != 0.0).collect(),
    )))
}
