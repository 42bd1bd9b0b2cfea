//! Parses the names that learning platforms give to submissions.
//!
//! - Canvas: `lastfirst_USER_FILE_name.zip` or `lastfirst_LATE_USER_FILE_name.zip`; a later
//!   upload has a greater FILE (`lib/content_zipper.rb` in the source of canvas-lms). Text that a
//!   student typed in is `lastfirst_USER_text.html`, and a link is `lastfirst_USER_link.html`. If
//!   the assignment is graded anonymously, `lastfirst` is `anon`, and USER is a random word.
//! - Moodle: `First Last_NUMBER_assignsubmission_file`, which names a folder or begins a file's
//!   name (`mod/assign/classes/downloader.php` in its source). The first part contains no `_`.
//! - Blackboard: `TITLE_LOGIN_attempt_2026-11-20-23-59-01_name.zip`.
//! - Brightspace: `NUMBER-NUMBER - First Last - Nov 20, 2026 1159 PM - name.zip`, or a folder
//!   with this name up to the time; the file `index.html` beside them lists all submissions.
//!
//! The uploader chooses the rest of a name, so it says nothing about the person or the time.

use jiff::civil::DateTime;
use serde::{Deserialize, Serialize};

/// What the name of an upload says about the person.
#[derive(Clone, Debug, Deserialize, Eq, Ord, PartialEq, PartialOrd, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Sign {
    /// An account on a platform: its number, and its name, which people may be able to change.
    Account {
        number: String,
        name: String,
        /// Moodle writes a group's name and number where it writes a person's.
        #[serde(default)]
        may_be_group: bool,
    },
    /// The assignment's title, `_`, and a login that the platform gave.
    Login(String),
    /// What somebody called a folder or an archive.
    Plain(String),
}

impl Sign {
    /// Whether it may name a group, as only Moodle's names do.
    pub fn may_be_group(&self) -> bool {
        matches!(
            self,
            Sign::Account {
                may_be_group: true,
                ..
            }
        )
    }
}

#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Platform {
    Canvas,
    Moodle,
    Blackboard,
    Brightspace,
}

const PLATFORMS: [Platform; 4] = [
    Platform::Canvas,
    Platform::Moodle,
    Platform::Blackboard,
    Platform::Brightspace,
];

/// A name given by a platform.
#[derive(Clone, Debug, PartialEq)]
pub struct PlatformName<'a> {
    pub platform: Platform,
    /// What names the person. On Blackboard, it begins with the assignment's title.
    pub person: &'a str,
    /// The platform's number for the person; empty on Blackboard.
    pub number: &'a str,
    /// What all files of one submission have in common.
    pub submission: String,
    /// Greater for later uploads, where the platform counts them.
    pub upload: u64,
    pub handed_in: Option<HandInTime<DateTime>>,
    /// Whether it contains several times. One of them is the platform's.
    pub has_several_times: bool,
    /// What the uploader called it.
    pub rest: &'a str,
}

impl PlatformName<'_> {
    pub fn sign(&self) -> Sign {
        match self.platform {
            Platform::Blackboard => Sign::Login(self.person.into()),
            _ => Sign::Account {
                number: self.number.into(),
                name: self.person.into(),
                may_be_group: self.platform == Platform::Moodle,
            },
        }
    }

    /// All ways to read a name as Canvas writes it. A person's name there may contain `_` and
    /// numbers, and so look like somebody else's name.
    fn canvas(name: &str) -> impl Iterator<Item = PlatformName<'_>> {
        // Canvas allows names of 255 characters, and each may be written as three. What follows may have
        // thousands of `_`, because the uploader chooses it.
        let after = name.char_indices().nth(3 * 255 + 1);
        let searched = &name[..after.map_or(name.len(), |(at, _)| at)];
        let ends = searched.match_indices('_');
        ends.filter_map(|(at, _)| PlatformName::canvas_of(name, &name[..at]))
    }

    fn canvas_of<'a>(name: &'a str, person: &'a str) -> Option<PlatformName<'a>> {
        let (mut number, mut rest) = name[person.len() + 1..].split_once('_')?;
        let is_late = number == "LATE";
        if is_late {
            (number, rest) = rest.split_once('_')?;
        }
        let (file, rest) = match rest {
            "text.html" | "link.html" => ("0", rest),
            _ => rest.split_once('_')?,
        };
        // Canvas's `LATE` is not a part of the person's name, except before `anon`.
        let ends_late = person
            .rsplit_once('_')
            .is_some_and(|(_, last)| last == "LATE");
        let is_late = is_late || person == "LATE_anon";
        let is_random =
            |text: &str| text.len() == 5 && text.bytes().all(|byte| byte.is_ascii_alphanumeric());
        let is_anonymous = ["anon", "LATE_anon"].contains(&person) && is_random(number);
        // Canvas drops hyphens, and GitHub writes one before a branch, which a student may have named.
        let is_account = (is_number(number) || is_anonymous) && !person.contains('-');
        // If it stands there twice, nobody knows.
        let is_same = ends_late && !is_late;
        (!is_same && is_account).then_some(PlatformName {
            platform: Platform::Canvas,
            person,
            number,
            submission: format!("{person}_{number}"),
            upload: file.parse().ok()?,
            handed_in: is_late.then_some(HandInTime::Late),
            has_several_times: false,
            rest,
        })
    }

    /// Reads a name as Moodle writes it, if it may be one. In the names of people and groups, Moodle
    /// replaces `_` by a space.
    fn moodle(name: &str) -> Option<PlatformName<'_>> {
        let (person, rest) = name.split_once('_')?;
        let (number, rest) = rest.split_once("_assignsubmission_")?;
        let (_, rest) = rest.split_once('_').unwrap_or((rest, ""));
        is_number(number).then_some(PlatformName {
            platform: Platform::Moodle,
            person,
            number,
            submission: format!("{person}_{number}"),
            upload: 0,
            handed_in: None,
            has_several_times: false,
            rest,
        })
    }

    /// Reads a name as Blackboard writes it, if it may be one.
    fn blackboard(name: &str) -> Option<PlatformName<'_>> {
        const MARK: &str = "_attempt_";
        let read = |(at, _): (usize, &str)| {
            let end = at + MARK.len() + "2026-11-20-23-59-01".len();
            let time = name.get(at + MARK.len()..end)?;
            let time = DateTime::strptime("%Y-%m-%d-%H-%M-%S", time).ok()?;
            let rest = &name[end..];
            let is_name = at > 0 && (rest.is_empty() || rest.starts_with(['_', '.']));
            is_name.then_some(PlatformName {
                platform: Platform::Blackboard,
                person: &name[..at],
                number: "",
                submission: name[..end].into(),
                upload: 0,
                handed_in: Some(HandInTime::At(time)),
                has_several_times: false,
                rest: rest.strip_prefix('_').unwrap_or(rest),
            })
        };
        with_latest_time(name.match_indices(MARK).filter_map(read).collect())
    }

    /// Reads a name as Brightspace writes it, if it may be one.
    fn brightspace(name: &str) -> Option<PlatformName<'_>> {
        const BETWEEN: &str = " - ";
        let (number, _) = name.split_once(BETWEEN)?;
        let (user, folder) = number.split_once('-')?;
        if !is_number(user) || !is_number(folder) {
            return None;
        }
        let begin = number.len() + BETWEEN.len();
        let read = |(at, _)| {
            let after = name[at..].strip_prefix(BETWEEN)?;
            let (time, rest) = after.split_once(BETWEEN).unwrap_or((after, ""));
            let at_time = brightspace_time(time)?;
            Some(PlatformName {
                platform: Platform::Brightspace,
                person: name.get(begin..at)?,
                number,
                submission: name[..at + BETWEEN.len() + time.len()].into(),
                upload: 0,
                handed_in: Some(HandInTime::At(at_time)),
                has_several_times: false,
                rest,
            })
        };
        // If a display name ends in a hyphen, two of them share a space.
        with_latest_time(name.char_indices().filter_map(read).collect())
    }
}

/// The first of these ways to read a name, but with the latest time, because the name of a person or
/// a group may contain an earlier time than the platform's.
fn with_latest_time(all: Vec<PlatformName<'_>>) -> Option<PlatformName<'_>> {
    let handed_in = all.iter().filter_map(|it| it.handed_in).max();
    let has_several_times = all.len() > 1;
    let first = all.into_iter().next()?;
    Some(PlatformName {
        handed_in,
        has_several_times,
        ..first
    })
}

/// A time as Brightspace writes it: no colon before the minutes, and no zero before the hour.
fn brightspace_time(text: &str) -> Option<DateTime> {
    let (text, half) = text.rsplit_once(' ')?;
    let (hour, minute) = text.split_at_checked(text.len().checked_sub(2)?)?;
    let text = format!("{hour}:{minute} {half}");
    DateTime::strptime("%b %d, %Y %I:%M %p", text).ok()
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// All ways to read a name as a platform's. An uploader can make a name look as if it were two
/// people's, or came from two platforms; then nobody knows which it is. The first of these ways has
/// the shortest name of a person.
pub fn platforms(name: &str) -> Vec<PlatformName<'_>> {
    // No platform gives names with a backslash, and in a ZIP file of reports they could lead out of
    // a folder.
    if name.contains('\\') {
        return Vec::new();
    }
    let others = [
        PlatformName::moodle(name),
        PlatformName::blackboard(name),
        PlatformName::brightspace(name),
    ];
    let mut all: Vec<_> = PlatformName::canvas(name)
        .chain(others.into_iter().flatten())
        .collect();
    all.sort_by_key(|it| it.person.len());
    all
}

/// All ways to read a name as that of the platform it comes from. If it doesn't look like that
/// platform's, or nobody knows the platform, all ways.
pub fn readings(name: &str, from: Option<Platform>) -> Vec<PlatformName<'_>> {
    let mut all = platforms(name);
    if all.iter().any(|it| Some(it.platform) == from) {
        all.retain(|it| Some(it.platform) == from);
    }
    all
}

/// The only one of these ways.
pub fn reading(name: &str, from: Option<Platform>) -> Option<PlatformName<'_>> {
    only(readings(name, from))
}

/// The single way to read a name; `None` if there are several, or none.
pub fn only(mut all: Vec<PlatformName<'_>>) -> Option<PlatformName<'_>> {
    all.pop().filter(|_| all.is_empty())
}

/// Whose upload this may be, given all ways to read its name: all with this text are one person's. If
/// there are several ways, its author may have made it look like somebody else's, so the text is
/// nobody's clear name.
pub fn account(name: &str, all: &[PlatformName]) -> String {
    match all {
        [] => name.into(),
        [only] => format!("{}_{}", only.person, only.number),
        [first, ..] => format!("{}_{}?", first.person, first.number),
    }
}

/// The platform that has exported a class: the one as whose most of its names can be read, given the
/// ways to read each. What an uploader adds to a name may look like another platform's.
pub fn exported_by<'a>(all: impl Iterator<Item = Vec<PlatformName<'a>>>) -> Option<Platform> {
    let all: Vec<_> = all.collect();
    let is_of = |readings: &[PlatformName], of| readings.iter().any(|it| it.platform == of);
    let count = |of| all.iter().filter(|it| is_of(it, of)).count();
    let mut counts = PLATFORMS.map(|it| (count(it), it));
    counts.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
    let [(most, platform), (next, _), ..] = counts;
    (most > next && 2 * most > all.len()).then_some(platform)
}

/// When something was handed in, according to its names.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub enum HandInTime<Time> {
    At(Time),
    /// Some time after the platform's deadline.
    Late,
}

/// When these files were handed in, according to the names that a platform gave to them. The latest
/// time counts, and one late file makes all of them late. If a name can be read in several ways, one
/// of them gives the platform's time. So what the uploader adds can only make a submission later.
pub fn handed_in(given: &[String], of: Platform) -> Option<HandInTime<DateTime>> {
    let names = given.iter().flat_map(|name| platforms(name));
    let names = names.filter(|name| name.platform == of);
    names.filter_map(|name| name.handed_in).max()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn most_names_tell_the_platform_whatever_uploaders_add() {
        let export = |names: &[&str]| exported_by(names.iter().map(|name| platforms(name)));
        let [ada, bob, eve] = [
            "Ada_11_assignsubmission_file_hw.zip",
            "Bob_12_assignsubmission_file_hw.zip",
            "Eve_13_assignsubmission_file_x_attempt_2026-11-20-10-00-00.zip",
        ];
        assert_eq!(export(&[ada, bob, eve]), Some(Platform::Moodle));
        assert_eq!(export(&[ada, eve, "index.html"]), Some(Platform::Moodle));
        // Nobody knows.
        assert_eq!(export(&[eve]), None);
        assert_eq!(export(&["1001", "1002", "manneve_11_1_hw.zip"]), None);
        assert_eq!(export(&[]), None);
    }

    #[test]
    fn no_name_of_a_person_hides_the_platforms_own_number() {
        let backticks = "%60".repeat(200);
        for name in [
            "x_LATE_LATE_13_502_Ada_12_501_hw.zip".to_owned(),
            "lovelaceada_12_13_502_".to_owned(),
            format!("lovelaceada_12_501_{backticks}_13_502_hw.zip"),
            "lovelaceada_12_501_\u{203f}Ⓐ_13_502_hw.zip".to_owned(),
        ] {
            let all = platforms(&name).into_iter();
            let numbers: Vec<&str> = all.map(|it| it.number).collect();
            assert!(numbers.contains(&"13"), "{name}: {numbers:?}");
        }
    }

    #[test]
    fn names_say_when_something_was_handed_in() {
        let of = |names: &[&str]| {
            let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
            let read = PLATFORMS.iter().filter_map(|of| handed_in(&names, *of));
            match read.max() {
                Some(HandInTime::At(time)) => time.to_string(),
                Some(HandInTime::Late) => "late".into(),
                None => "unknown".into(),
            }
        };
        for (names, said) in [
            (
                &["HW1_al1_attempt_2026-11-20-23-59-01_hw_attempt_2020-01-01-00-00-00.zip"][..],
                "2026-11-20T23:59:01",
            ),
            (
                &["HW1_x_attempt_2026-01-01-00-00-00_y_attempt_2026-11-20-23-59-01_hw.zip"],
                "2026-11-20T23:59:01",
            ),
            (
                &["11-22 - Ada Lovelace - Nov 21, 2026 1207 AM - hw1.zip"],
                "2026-11-21T00:07:00",
            ),
            (
                &["11-22 - Ada Lovelace - Nov 20, 2026 926 PM"],
                "2026-11-20T21:26:00",
            ),
            (
                &["11-22 - Ada Lovelace - Nov 20, 2026 100 PM - hw1.zip"],
                "2026-11-20T13:00:00",
            ),
            (&["lovelaceada_LATE_11_501_hw1.zip"], "late"),
            (
                &[
                    "lovelaceada_11_501_sphere.rs",
                    "lovelaceada_LATE_11_502_plane.rs",
                ],
                "late",
            ),
            (&["lovelaceada_11_501_hw1_LATE.zip"], "unknown"),
            (&["LATE_anon_x7Kp2_501_hw1.zip"], "late"),
            (&["ada"], "unknown"),
            (
                &["11-23 - Mallory - Nov 1, 2026 1200 AM - Mann - Nov 25, 2026 1100 PM - hw1.zip"],
                "2026-11-25T23:00:00",
            ),
            (
                &["11-23 - Mallory - - Nov 25, 2026 1100 PM - x - Nov 1, 2026 1200 AM - y.zip"],
                "2026-11-25T23:00:00",
            ),
            // The uploader's part of a name doesn't hide that the upload is late.
            (
                &["HW1_mm1_attempt_2026-11-25-23-59-01_x_12_501_y.zip"],
                "2026-11-25T23:59:01",
            ),
            (
                &["11-23 - Mallory - Nov 25, 2026 1100 PM - x_12_501_y.zip"],
                "2026-11-25T23:00:00",
            ),
            (
                &["malletmallory_LATE_13_503_x_attempt_2020-01-01-00-00-00_hw.zip"],
                "late",
            ),
        ] {
            assert_eq!(of(names), said, "{names:?}");
        }
        let long = format!(
            "HW1_mm1_attempt_2026-11-25-20-00-00_{}.zip",
            "x".repeat(240)
        );
        assert_eq!(of(&[&long]), "2026-11-25T20:00:00");
    }

    #[test]
    fn a_platforms_part_of_a_name_is_distinguished_from_the_uploaders() {
        let canvas = |name| {
            let mut all = PlatformName::canvas(name);
            let first = all.next().map(|it| (it.person, it.number, it.upload));
            first.filter(|_| all.next().is_none())
        };
        let ada = Some(("lovelaceada", "12", 501));
        assert_eq!(canvas("lovelaceada_12_501_answers.zip"), ada);
        assert_eq!(canvas("lovelaceada_LATE_12_501_sphere-1.rs"), ada);
        assert_eq!(canvas("homework_2"), None);
        assert_eq!(canvas("hw1-mal-ada_11_501_x"), None);
        // A name of symbols only is empty, and one may end like Canvas's mark of late uploads.
        assert_eq!(canvas("_LATE_12_501_hw.zip"), Some(("", "12", 501)));
        let late = canvas("mann_late_LATE_12_501_hw.zip");
        assert_eq!(late, Some(("mann_late", "12", 501)));
        let typed = Some(("lovelaceada", "12", 0));
        assert_eq!(canvas("lovelaceada_12_text.html"), typed);
        assert_eq!(canvas("lovelaceada_LATE_12_link.html"), typed);
        let anonymous = Some(("anon", "x7Kp2", 501));
        assert_eq!(canvas("anon_x7Kp2_501_hw1.zip"), anonymous);
        assert_eq!(canvas("bnon_x7Kp2_501_hw1.zip"), None);
        assert_eq!(canvas("anon_x7Kp23_501_hw1.zip"), None);
        let moodle = PlatformName::moodle("Ada Lovelace_2001_assignsubmission_file_");
        assert_eq!(
            moodle.map(|it| (it.person, it.number)),
            Some(("Ada Lovelace", "2001"))
        );
        let flat = PlatformName::moodle("Ada Lovelace_2001_assignsubmission_file_hw1.zip");
        assert_eq!(flat.map(|it| it.rest), Some("hw1.zip"));
        let bright = "11-22 - Ada Lovelace - Nov 21, 2026 1207 AM - Bob - Nov 1, 2026 1207 AM - x";
        let bright = PlatformName::brightspace(bright);
        assert_eq!(
            bright.map(|it| (it.person, it.rest)),
            Some(("Ada Lovelace", "Bob - Nov 1, 2026 1207 AM - x"))
        );
        let bright = PlatformName::brightspace("11-x - Ada Lovelace - Nov 21, 2026 1207 AM - hw");
        assert!(bright.is_none());
        let black = PlatformName::blackboard("HW_1_al1_attempt_2026-11-20-23-59-01.txt");
        assert_eq!(
            black.map(|it| (it.person, it.rest)),
            Some(("HW_1_al1", ".txt"))
        );
        for other in [
            "HW_1_al1_attempt_2026-11-20-23-59-01x",
            "_attempt_2026-11-20-23-59-01",
        ] {
            assert!(PlatformName::blackboard(other).is_none(), "{other}");
        }
        let longest = format!("{}_12_501_{}.zip", "i\u{307}".repeat(255), "x".repeat(255));
        assert_eq!(platforms(&longest).len(), 1);
        // Moodle's names of people contain no `_`, so this is only one of Canvas's.
        let canvas = platforms("malletmallory_13_503_x_20231234_assignsubmission_file.zip");
        assert_eq!(canvas.len(), 1);
    }
}
