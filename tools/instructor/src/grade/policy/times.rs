//! When something was handed in, and how late that is.

use jiff::civil::DateTime;
use jiff::tz::TimeZone;
use jiff::{SignedDuration, Span, Timestamp, Unit, Zoned};

use super::Policy;
use super::rules::Per;
use crate::grade::intake::Entry;
use crate::grade::intake::names::{self, HandedIn};
use crate::grade::intake::roster::Person;

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
    /// Nothing says when it was handed in.
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
    /// When a submission was handed in: as the table of times says or, if it doesn't, as the
    /// names of its files say.
    pub fn handed_in(&self, entry: &Entry, person: Option<&Person>) -> Option<HandedIn<Timestamp>> {
        let given = [&entry.id, &entry.name];
        let of_entry = given.into_iter().find_map(|name| self.times.get(name));
        let of_person = || {
            let person = person?;
            let signs = entry.signs.iter().filter_map(|sign| sign.number.as_ref());
            let keys = std::iter::once(&person.id);
            let keys = keys.chain(&person.number).chain(&person.logins);
            keys.chain(signs).find_map(|key| self.times.get(key))
        };
        // If one person has several times, nobody knows which belongs to this submission. The
        // last one is certainly not too early.
        let listed = of_entry.or_else(of_person).and_then(|all| all.iter().max());
        if let Some(time) = listed {
            return Some(HandedIn::At(*time));
        }
        let zone = self.zone();
        let named = names::handed_in(&entry.given)?;
        Some(match named {
            HandedIn::Late => HandedIn::Late,
            HandedIn::At(local) => HandedIn::At(local.to_zoned(zone).ok()?.timestamp()),
        })
    }

    /// The deadline of these people, which is the latest that one of them has.
    fn due(&self, people: &[&Person]) -> Option<Zoned> {
        let own = people.iter().filter_map(|it| self.extensions.get(&it.id));
        let due = own.copied().chain(self.deadline).max()?;
        Some(due.to_zoned(self.zone()))
    }

    /// Whether a submission meets the deadline of those who handed it in.
    pub fn lateness(&self, entry: &Entry, people: &[&Person]) -> Lateness {
        let Some(due) = self.due(people) else {
            return Lateness::InTime;
        };
        let grace = self.rules.grace.as_deref().and_then(|it| grace(it).ok());
        match self.handed_in(entry, people.first().copied()) {
            None => Lateness::Unknown,
            // Somebody with an extension may still have met their own deadline.
            Some(HandedIn::Late) => Lateness::LateSometime,
            Some(HandedIn::At(at)) => {
                let at = at.to_zoned(self.zone());
                match at.timestamp().duration_since(due.timestamp()) <= grace.unwrap_or_default() {
                    true => Lateness::InTime,
                    false => Lateness::Late { due, at },
                }
            }
        }
    }

    /// How many late days somebody has left.
    pub fn late_days_left(&self, id: &str) -> u32 {
        let budget = self.rules.late_days.as_ref().map_or(0, |it| it.budget);
        budget.saturating_sub(self.spent.get(id).copied().unwrap_or(0))
    }
}

/// How many hours or days have begun since a deadline; 0 if it is met.
pub fn begun(due: &Zoned, at: &Zoned, per: Per) -> u32 {
    if at <= due {
        return 0;
    }
    let unit = match per {
        Per::Hour => Unit::Hour,
        Per::Day => Unit::Day,
    };
    let Ok(span) = due.until((unit, at)) else {
        return u32::MAX;
    };
    let whole = match per {
        Per::Hour => i64::from(span.get_hours()),
        Per::Day => i64::from(span.get_days()),
    };
    let is_more = later(due, whole, per).is_some_and(|end| end < *at);
    u32::try_from(whole + i64::from(is_more)).unwrap_or(u32::MAX)
}

/// A number of hours or days after a deadline.
pub fn later(due: &Zoned, count: i64, per: Per) -> Option<Zoned> {
    let span = match per {
        Per::Hour => Span::new().try_hours(count),
        Per::Day => Span::new().try_days(count),
    };
    due.checked_add(span.ok()?).ok()
}
