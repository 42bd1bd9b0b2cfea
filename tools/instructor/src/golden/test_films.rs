//! Stores how many tests the reference takes for each pixel of a scene. These counts are not
//! judged. They are shown beside a submission's own.

use std::path::PathBuf;

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::compile;
use pinhole_course::error::Result;
use pinhole_course::goldens::{Goldens, tests_beside};
use pinhole_course::mistake_films;
use pinhole_course::overlay;
use pinhole_course::sandbox::Sandbox;

/// Writes a film of tests beside each scene's golden, if the reference counts any. Returns the
/// files that were written, as paths inside the folder.
pub fn make(
    assignment: &Assignment,
    goldens: &Goldens,
    checkout: &Checkout,
) -> Result<Vec<PathBuf>> {
    let reference = overlay::reference(assignment)?;
    let program = compile(&reference, assignment, checkout, &Sandbox::Trusted)?;
    let mut written = Vec::new();
    for scene in &goldens.scenes {
        let film = goldens.scene_film(scene)?;
        let reply = mistake_films::ask(&program, &film)?;
        if let Some(tests) = reply.own_tests(film.resolution) {
            let path = tests_beside(&film.golden_path);
            tests.write(&path)?;
            written.extend(path.file_name().map(PathBuf::from));
        }
    }
    Ok(written)
}
