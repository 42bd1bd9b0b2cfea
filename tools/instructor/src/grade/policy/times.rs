//! When something was handed in, and how late that is.

use jiff::civil::DateTime;
use jiff::tz::TimeZone;
use jiff::{SignedDuration, Span, Timestamp, Unit, Zoned};

use super::rules::LatenessUnit;
use super::{Policy, TimeKey};
use crate::grade::intake::Entry;
use crate::grade::intake::matching::{is_anothers_login, is_own_number};
use crate::grade::intake::names::{self, HandInTime, Sign};
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
    /// What the table of times says under a key. If there are several times, we don't know which is
    /// meant. Take the last one, so that nobody gets away with being late.
    fn listed(&self, kind: TimeKey, key: &str) -> Option<Timestamp> {
        let all = self.times.get(key)?.iter();
        let own = all.filter(|(own, _)| *own == kind);
        own.map(|(_, time)| *time).max()
    }

    /// A person's login that is in the table of times, but is somebody else's, too. Nobody knows
    /// whose time that is.
    pub fn contested_login<'a>(&self, person: &'a Person, people: &[Person]) -> Option<&'a String> {
        let is_listed = |login: &&String| self.listed(TimeKey::Login, login).is_some();
        let mut logins = person.all_logins().filter(is_listed);
        logins.find(|login| is_anothers_login(login, person, people))
    }

    /// When a submission was handed in, according to the table of times or, if it doesn't say,
    /// the names of its files. `people` is the roster.
    pub fn handed_in(
        &self,
        entry: &Entry,
        person: Option<&Person>,
        people: &[Person],
    ) -> Option<HandInTime<Timestamp>> {
        let given = [&entry.id, &entry.name];
        let mut keys: Vec<_> = given.map(|name| (TimeKey::Submission, name)).to_vec();
        if person.is_none() {
            keys.extend(given.map(|name| (TimeKey::Id, name)));
        }
        if let Some(person) = person {
            let signs = entry.signs.iter().filter_map(|sign| match sign {
                Sign::Account {
                    number,
                    name,
                    may_be_group,
                } if is_own_number(number, name, *may_be_group, person) => Some(number),
                _ => None,
            });
            keys.push((TimeKey::Id, &person.id));
            keys.extend(person.number.iter().map(|it| (TimeKey::Number, it)));
            let logins = person.all_logins();
            let logins = logins.filter(|it| !is_anothers_login(it, person, people));
            keys.extend(logins.map(|it| (TimeKey::Login, it)));
            keys.extend(signs.map(|it| (TimeKey::Number, it)));
        }
        let mut keys = keys.into_iter();
        if let Some(time) = keys.find_map(|(kind, key)| self.listed(kind, key)) {
            return Some(HandInTime::At(time));
        }
        let zone = self.zone();
        let named = names::handed_in(&entry.given)?;
        Some(match named {
            HandInTime::Late => HandInTime::Late,
            HandInTime::At(local) => {
                let time = local.to_zoned(zone).map(|time| time.timestamp());
                // Only an uploader writes a time that is beyond the last one there is.
                HandInTime::At(time.unwrap_or(Timestamp::MAX))
            }
        })
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
