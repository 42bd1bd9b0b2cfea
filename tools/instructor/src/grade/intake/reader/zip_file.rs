//! A ZIP file, of which only the files that matter are unpacked.

use std::fs::File;
use std::io::Write;

use pinhole_course::submission::AnswerFileProblem;
use pinhole_course::submission::archive::{Archive, MOST_READ};

use super::limits::LimitedStream;
use super::unpack::{ReadFailure, UnreadFile};
use super::{Reader, TopNames};

/// Reads the files that matter.
pub fn read(
    reader: &mut Reader,
    file: File,
    path: &[String],
    depth: usize,
) -> Result<(), ReadFailure> {
    let length = file.metadata().map_or(0, |it| it.len());
    let file = LimitedStream {
        inner: file,
        limits: reader.limits(path),
        of: |it| &it.passed,
    };
    // The list of a whole class may be long.
    let most = match depth {
        0 => MOST_READ.max(length),
        _ => MOST_READ,
    };
    let mut archive = Archive::new(file, most).map_err(ReadFailure::Refused)?;
    if depth == 0 {
        let mut names = TopNames::default();
        for path in archive.files() {
            names.add(path);
        }
        reader.name_submissions(names);
    }
    for (name, why) in archive.misplaced() {
        let refused = reader.refuse(path, depth, name, why);
        refused.map_err(ReadFailure::Refused)?;
    }
    let files: Vec<String> = archive.files().map(str::to_owned).collect();
    for name in files {
        let Some(inside) = reader.enter(path, &name) else {
            continue;
        };
        if !reader.wants(&inside) {
            reader.pass(&inside, true);
            continue;
        }
        let mut copy = |most: u64, to: &mut dyn Write| {
            archive.unpack(&name, most, to).map_err(|why| match why {
                AnswerFileProblem::Refused(why) => ReadFailure::Refused(why),
                AnswerFileProblem::Missing => ReadFailure::Refused("it is not there".into()),
            })
        };
        reader.file(&inside, depth, UnreadFile::Packed(&mut copy));
    }
    Ok(())
}
