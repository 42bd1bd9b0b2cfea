//! When something was handed in, and how late that is.

use jiff::civil::DateTime;
use jiff::tz::TimeZone;
use jiff::{SignedDuration, Span, Timestamp, Unit, Zoned};
use serde::{Deserialize, Serialize};

use super::rules::LatenessUnit;
use super::{Policy, TimeKey};
use crate::grade::intake::Entry;
use crate::grade::intake::matching::{is_anothers_login, is_own_number};
use crate::grade::intake::names::{self, HandInTime, Sign};
use crate::grade::intake::reader::file_names;
use crate::grade::intake::roster::Person;
use pinhole_report::escape::printable_cell;

/// Whether a submission is late, and how late.
#[derive(Clone, Debug, PartialEq)]
pub enum Lateness {
    /// There is no deadline, or it was met.
    InTime,
    Late {
        /// The deadline, in the policy's time zone.
        due: Zoned,
        at: Zoned,
    },
    /// The platform says that it is late, but not when it came.
    LateSometime,
    /// It is unknown when it was handed in.
    Unknown,
}

/// A line of the table of times.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct TimeLine {
    /// The id, number, login and submission on it. One person's number or login may be another's
    /// id, so each is stored with its kind.
    pub keys: Vec<(TimeKey, String)>,
    /// The time; `None` if the person has handed in nothing.
    pub at: Option<Timestamp>,
    /// The time as the table writes it, perhaps without a time zone.
    #[serde(default)]
    pub said: String,
}

impl TimeLine {
    /// Whether both say the same of a person, and not of different submissions. The policy's time zone
    /// may have been corrected.
    pub fn is_same(&self, other: &TimeLine) -> bool {
        let submission = |line: &TimeLine| {
            let mut keys = line.keys.iter();
            keys.find(|(kind, _)| *kind == TimeKey::Submission).cloned()
        };
        let of = submission(self).zip(submission(other));
        let has_key = self.keys.iter().any(|key| other.keys.contains(key));
        has_key
            && of.is_none_or(|(own, other)| own == other)
            && (self.said == other.said || self.at == other.at)
    }

    fn has(&self, (kind, key): &(TimeKey, &String)) -> bool {
        let is = |text: &String| match kind {
            TimeKey::Login => text.eq_ignore_ascii_case(key),
            _ => text == *key,
        };
        let mut keys = self.keys.iter();
        keys.any(|(own, text)| own == kind && is(text))
    }

    /// Whether it has a person's id or number, or a login that `other` doesn't have.
    fn is_of(&self, person: &Person, other: &Person) -> bool {
        let numbers = person.number.iter().map(|it| (TimeKey::Number, it));
        let logins = person.logins.iter().filter(|it| !other.logins.contains(it));
        let logins = logins.map(|it| (TimeKey::Login, it));
        let mut keys = numbers.chain(logins).chain([(TimeKey::Id, &person.id)]);
        keys.any(|key| self.has(&key))
    }

    /// Whether it has an address, but none of a person whose addresses are known.
    fn has_another_address(&self, person: &Person) -> bool {
        let is_address = |it: &&String| it.contains('@');
        let own: Vec<&String> = person.all_logins().filter(is_address).collect();
        let logins = self.keys.iter().filter(|(kind, _)| *kind == TimeKey::Login);
        let given: Vec<&String> = logins.map(|(_, text)| text).filter(is_address).collect();
        let is_own = |given: &&String| own.iter().any(|it| it.eq_ignore_ascii_case(given));
        !own.is_empty() && !given.is_empty() && !given.iter().any(is_own)
    }

    /// What identifies the person.
    fn person(&self) -> Vec<&(TimeKey, String)> {
        let keys = self.keys.iter();
        keys.filter(|(kind, _)| *kind != TimeKey::Submission)
            .collect()
    }
}

/// What the table of times says about a person.
#[derive(Debug, PartialEq)]
enum ListedTime<'a> {
    Absent,
    At(&'a TimeLine),
    /// This id, login or submission's name is also another person's.
    Contested(String),
}

impl<'a> ListedTime<'a> {
    fn or(self, other: impl FnOnce() -> ListedTime<'a>) -> ListedTime<'a> {
        match self {
            ListedTime::Absent => other(),
            said => said,
        }
    }
}

/// Whether these lines identify different people.
fn are_of_several(lines: &[&TimeLine]) -> bool {
    lines.iter().any(|line| line.person() != lines[0].person())
}

/// The last time on these lines. If there are several, we don't know which is meant, and nobody should
/// get away with being late.
fn last<'a>(lines: &[&'a TimeLine]) -> ListedTime<'a> {
    let lines = lines.iter().filter(|line| line.at.is_some());
    let last = lines.max_by_key(|line| line.at);
    last.map_or(ListedTime::Absent, |line| ListedTime::At(line))
}

/// A time zone by its name.
pub fn zone(name: Option<&str>) -> Result<Option<TimeZone>, String> {
    let Some(name) = name else { return Ok(None) };
    let zone = TimeZone::get(name);
    zone.map(Some)
        .map_err(|_| format!("time_zone is `{name}`, which is not a zone like Europe/Berlin"))
}

/// A length of time, as in `15 minutes`.
pub fn grace(text: &str) -> Result<SignedDuration, String> {
    let grace: Result<SignedDuration, _> = text.parse();
    let grace = grace.ok().filter(|grace| !grace.is_negative());
    grace.ok_or_else(|| format!("grace is `{text}`, which is not a time like `15 minutes`"))
}

/// A time as people and platforms write it: with an offset, or in the policy's zone.
pub fn timestamp(text: &str, zone: Option<&TimeZone>) -> Result<Timestamp, String> {
    let text = text.trim();
    let with_offset = [
        text.parse::<Timestamp>().ok(),
        Timestamp::strptime("%Y-%m-%d %H:%M:%S %z", text).ok(),
        Timestamp::strptime("%Y-%m-%d %H:%M %z", text).ok(),
    ];
    if let Some(time) = with_offset.into_iter().flatten().next() {
        return Ok(time);
    }
    let local = [
        text.parse::<DateTime>()
            .ok()
            .filter(|_| text.len() > "2026-11-20".len()),
        // Moodle's format, in English.
        DateTime::strptime("%A, %d %B %Y, %I:%M %p", text).ok(),
    ];
    let Some(local) = local.into_iter().flatten().next() else {
        return Err(format!("`{text}` is not a time like `2026-11-20 23:59`"));
    };
    let Some(zone) = zone else {
        return Err(format!(
            "`{text}` needs a `time_zone`, such as Europe/Berlin"
        ));
    };
    let zoned = local.to_zoned(zone.clone());
    zoned
        .map(|zoned| zoned.timestamp())
        .map_err(|error| error.to_string())
}

impl Policy {
    /// The lines of the table of times that have one of these keys.
    fn lines(&self, keys: &[(TimeKey, &String)]) -> Vec<&TimeLine> {
        let has = |line: &&TimeLine| keys.iter().any(|key| line.has(key));
        self.times.iter().filter(has).collect()
    }

    /// What the table of times says about a submission or, if it doesn't name it, about the person
    /// who handed it in. `people` is the roster.
    fn in_table(
        &self,
        entry: &Entry,
        person: Option<&Person>,
        people: &[Person],
    ) -> ListedTime<'_> {
        if self.times.is_empty() {
            return ListedTime::Absent;
        }
        // Not its id, which may be another submission's name.
        let given = [entry.name.clone(), file_names::stem(&entry.name).into()];
        let of = |kind| self.lines(&given.each_ref().map(|name| (kind, name)));
        let named = of(TimeKey::Submission);
        let Some(person) = person else {
            let by_id = of(TimeKey::Id);
            let is_known = by_id.is_empty() || named.iter().any(|line| by_id.contains(line));
            // The members of a group have the same time.
            let differ = are_of_several(&named) && named.iter().any(|it| it.at != named[0].at);
            return match differ || !is_known && !named.is_empty() || are_of_several(&by_id) {
                true => ListedTime::Contested(entry.name.clone()),
                false => last(&named).or(|| last(&by_id)),
            };
        };
        // Without a platform, or in a name with several meanings, the number may be another's.
        let number = match &entry.signs[..] {
            [
                Sign::Account {
                    number,
                    name,
                    may_be_group,
                },
            ] if entry.platform.is_some() && is_own_number(number, name, *may_be_group, person) => {
                Some(number)
            }
            _ => None,
        };
        let numbers = person.number.iter().chain(number);
        let (shared, own): (Vec<_>, Vec<_>) = person
            .all_logins()
            .partition(|it| is_anothers_login(it, person, people));
        let mut keys = vec![(TimeKey::Id, &person.id)];
        keys.extend(numbers.map(|it| (TimeKey::Number, it)));
        keys.extend(own.into_iter().map(|it| (TimeKey::Login, it)));
        let team = self.group_of(&person.id).into_iter();
        let team: Vec<_> = team.flat_map(|it| &it.members).collect();
        let is_theirs = |line: &&TimeLine| {
            let mut ids = team.iter().map(|id| (TimeKey::Id, *id));
            line.person().is_empty()
                || keys.iter().any(|key| line.has(key))
                || ids.any(|key| line.has(&key))
        };
        // Another person may have given a submission this name.
        if !named.iter().all(is_theirs) {
            return ListedTime::Contested(entry.name.clone());
        }
        let listed = self.lines(&keys);
        // On some platforms, people can type in anybody's id or address.
        let mut others = people.iter().filter(|other| other.id != person.id);
        let is_others = others.any(|other| listed.iter().any(|line| line.is_of(other, person)));
        let is_others = is_others || listed.iter().any(|it| it.has_another_address(person));
        if is_others || are_of_several(&listed) {
            let is_there = |key: &&(TimeKey, &String)| listed.iter().all(|line| line.has(key));
            let key = keys.iter().find(is_there).unwrap_or(&keys[0]);
            return last(&named).or(|| ListedTime::Contested(key.1.clone()));
        }
        // Nobody knows whose time it is that stands under a login of two people.
        let mut shared = shared.into_iter();
        let contested = || {
            let login = shared.find(|it| !self.lines(&[(TimeKey::Login, it)]).is_empty());
            login.map_or(ListedTime::Absent, |it| ListedTime::Contested(it.clone()))
        };
        last(&named).or(|| last(&listed)).or(contested)
    }

    /// The line of the table of times that counts for a submission.
    pub fn line_of(
        &self,
        entry: &Entry,
        person: Option<&Person>,
        people: &[Person],
    ) -> Option<&TimeLine> {
        match self.in_table(entry, person, people) {
            ListedTime::At(line) => Some(line),
            ListedTime::Absent | ListedTime::Contested(_) => None,
        }
    }

    /// When a submission was handed in, according to the table of times or, if it doesn't say,
    /// the names of its files. `people` is the roster.
    ///
    /// # Errors
    /// If neither says, but the table has a line with this id or login, which is perhaps another
    /// person's.
    pub fn handed_in(
        &self,
        entry: &Entry,
        person: Option<&Person>,
        people: &[Person],
    ) -> Result<Option<HandInTime<Timestamp>>, String> {
        let listed = self.in_table(entry, person, people);
        if let ListedTime::At(line) = listed {
            return Ok(line.at.map(HandInTime::At));
        }
        match (self.named(entry), listed) {
            (None, ListedTime::Contested(key)) => Err(key),
            (named, _) => Ok(named),
        }
    }

    /// When a submission was handed in, according to the names of its files.
    pub fn named(&self, entry: &Entry) -> Option<HandInTime<Timestamp>> {
        let named = names::handed_in(&entry.given, entry.platform?)?;
        Some(match named {
            HandInTime::Late => HandInTime::Late,
            HandInTime::At(local) => {
                let time = local.to_zoned(self.zone()).map(|time| time.timestamp());
                // Only an uploader writes a time that is beyond the last one there is.
                HandInTime::At(time.unwrap_or(Timestamp::MAX))
            }
        })
    }

    /// Whether a time is not after the deadline that people without an extension have.
    pub fn is_early(&self, time: Timestamp) -> bool {
        self.deadline.is_some_and(|due| time <= due)
    }

    /// The deadline of these people: the latest that any of them has.
    fn due(&self, people: &[&Person]) -> Option<Zoned> {
        let own = people.iter().filter_map(|it| self.extensions.get(&it.id));
        let due = own.copied().chain(self.deadline).max()?;
        Some(due.to_zoned(self.zone()))
    }

    /// Whether something that was handed in at this time meets the deadline of these people.
    pub fn lateness(&self, at: Option<HandInTime<Timestamp>>, people: &[&Person]) -> Lateness {
        let Some(due) = self.due(people) else {
            return Lateness::InTime;
        };
        let grace = self.rules.grace.as_deref().and_then(|it| grace(it).ok());
        match at {
            None => Lateness::Unknown,
            // A person with an extension may still have met their own deadline.
            Some(HandInTime::Late) => Lateness::LateSometime,
            Some(HandInTime::At(at)) => {
                let at = at.to_zoned(self.zone());
                match at.timestamp().duration_since(due.timestamp()) <= grace.unwrap_or_default() {
                    true => Lateness::InTime,
                    false => Lateness::Late { due, at },
                }
            }
        }
    }

    /// How many late days a person has left.
    pub fn late_days_left(&self, id: &str) -> u32 {
        let budget = self.rules.late_days.as_ref().map_or(0, |it| it.budget);
        let spent = self.spent.get(&printable_cell(id));
        budget.saturating_sub(spent.copied().unwrap_or(0))
    }
}

/// How many hours or days have begun since a deadline; 0 if it is met.
pub fn begun(due: &Zoned, at: &Zoned, per: LatenessUnit) -> u32 {
    if at <= due {
        return 0;
    }
    let unit = match per {
        LatenessUnit::Hour => Unit::Hour,
        LatenessUnit::Day => Unit::Day,
    };
    let Ok(span) = due.until((unit, at)) else {
        return u32::MAX;
    };
    let whole = match per {
        LatenessUnit::Hour => i64::from(span.get_hours()),
        LatenessUnit::Day => i64::from(span.get_days()),
    };
    let is_more = later(due, whole, per).is_some_and(|end| end < *at);
    u32::try_from(whole + i64::from(is_more)).unwrap_or(u32::MAX)
}

/// The time that is a number of hours or days after a deadline.
pub fn later(due: &Zoned, count: i64, per: LatenessUnit) -> Option<Zoned> {
    let span = match per {
        LatenessUnit::Hour => Span::new().try_hours(count),
        LatenessUnit::Day => Span::new().try_days(count),
    };
    due.checked_add(span.ok()?).ok()
}
