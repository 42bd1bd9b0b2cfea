//! The roster: the list of a course's people, as a spreadsheet or a learning platform
//! writes it.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::table::Table;
use pinhole_course::error::Result;

/// A person on the roster.
#[derive(Clone, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
pub struct Person {
    pub id: String,
    /// Whether the university assigned the id. Otherwise, the platform's number, an address or a
    /// login stands in for it.
    pub has_assigned_id: bool,
    pub name: String,
    #[serde(default)]
    pub section: String,
    /// The learning platform's number for the person, if the roster has it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub number: Option<String>,
    /// Logins and e-mail addresses assigned by the university.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub logins: Vec<String>,
    /// The login on GitHub, which people choose themselves.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub github: Option<String>,
    /// The name of the person's group, which people may choose themselves, if submissions may be
    /// named after it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub group: Option<String>,
}

impl Person {
    /// The logins of the university and the one on GitHub.
    pub fn all_logins(&self) -> impl Iterator<Item = &String> {
        self.logins.iter().chain(&self.github)
    }

    /// The logins that the university assigned.
    pub fn assigned_logins(&self) -> impl Iterator<Item = &String> {
        self.logins.iter().filter(|it| !it.contains('@'))
    }

    /// E-mail addresses. On some platforms, people type them in.
    pub fn addresses_in_full(&self) -> impl Iterator<Item = &str> {
        let logins = self.logins.iter().map(String::as_str);
        logins.filter(|it| it.contains('@'))
    }

    /// E-mail addresses, and their parts before the `@`.
    pub fn addresses(&self) -> impl Iterator<Item = &str> {
        let all = self.addresses_in_full();
        all.flat_map(|it| [it, it.split_once('@').map_or(it, |(local, _)| local)])
    }
}

/// Names of columns, in lower case and without spaces: ours, and those of Canvas's gradebook,
/// Moodle's lists in English and German, and the rosters of GitHub's classrooms. If a table has
/// several of them, the first in this list counts. If a person has no id in that column, the next
/// column counts.
const ID: [&str; 12] = [
    "sisuserid",
    "idnumber",
    "idnummer",
    "studentid",
    "studentnumber",
    "matriculationnumber",
    "matrikelnummer",
    "id",
    "identifier",
    "emailaddress",
    "emailadresse",
    "username",
];
const NAME: [&str; 6] = [
    "name",
    "fullname",
    "vollständigername",
    "student",
    "studentname",
    "displayname",
];
const FIRST: [&str; 4] = ["firstname", "givenname", "forename", "vorname"];
const LAST: [&str; 5] = ["lastname", "surname", "familyname", "lastnames", "nachname"];
const SECTION: [&str; 5] = ["section", "group", "groups", "gruppe", "gruppen"];
const NUMBER: [&str; 4] = ["number", "canvasid", "moodleid", "identifier"];
const LOGIN: [&str; 9] = [
    "sisloginid",
    "loginid",
    "login",
    "username",
    "anmeldename",
    "benutzername",
    "email",
    "emailaddress",
    "emailadresse",
];
const GITHUB: [&str; 3] = ["github", "githubusername", "githublogin"];

/// The name on the line of Canvas's gradebook that has the possible points, and no id.
const POINTS_POSSIBLE: &str = "Points Possible";

/// The people of a course, in the file's order.
pub fn read(path: &Path) -> Result<Vec<Person>> {
    let remedy = "correct it, or save it as a CSV file whose first line is: id,name,section";
    Table::read(path, "roster", remedy, people)
}

/// The people in a table, or a message that says what is wrong.
fn people(table: Table) -> std::result::Result<Vec<Person>, String> {
    let of = |names: &[&str]| table.column(names);
    let said = format!("its first line is `{}`", table.first_line);
    let ids: Vec<usize> = ID.iter().filter_map(|name| of(&[name])).collect();
    let id = *ids
        .first()
        .ok_or(format!("{said}, which has no column `id`"))?;
    let name = of(&NAME);
    let parts = [of(&FIRST), of(&LAST)];
    if name.is_none() && parts == [None, None] {
        return Err(format!("{said}, which has no column `name`"));
    }
    let [section, number] = [of(&SECTION), of(&NUMBER)];
    // In Canvas's gradebook, `ID` is Canvas's own number, and in Moodle's German lists, Moodle's.
    let is_points = |(_, row): &(u64, csv::StringRecord)| {
        let cell = |at: Option<usize>| at.and_then(|at| row.get(at)).unwrap_or_default().trim();
        // Someone may call themselves so.
        let is_nobody = ids.iter().all(|at| cell(Some(*at)).is_empty());
        is_nobody && cell(name.or(parts[1])) == POINTS_POSSIBLE
    };
    let is_platforms =
        of(&["sisuserid", "sisloginid", "idnummer"]).is_some() || table.rows.iter().any(is_points);
    let number = number.or(of(&["id"]).filter(|_| is_platforms));
    // In the rosters of GitHub's classrooms, `identifier` is the id that the instructor chose and, in
    // Classroom 50's, `username` is the login on GitHub.
    let is_classroom = of(&["githubid", "githubusername"]).is_some();
    let number = number.filter(|_| !is_classroom);
    let github = of(&GITHUB).or(of(&["username"]).filter(|_| is_classroom));
    let logins = LOGIN.iter().filter_map(|name| of(&[name]));
    let logins: Vec<usize> = logins.filter(|at| Some(*at) != github).collect();
    let is_assigned = |column: usize| match table.name(column) {
        "id" => !is_platforms,
        "identifier" => is_classroom,
        "emailaddress" | "emailadresse" | "username" => false,
        _ => true,
    };

    let mut people: Vec<Person> = Vec::new();
    for (line, row) in &table.rows {
        let cell = |at: Option<usize>| at.and_then(|at| row.get(at)).unwrap_or_default().trim();
        let name = match name {
            Some(_) => cell(name).to_owned(),
            None => parts.map(cell).join(" ").trim().to_owned(),
        };
        // Skip the lines of Canvas's gradebook that are about no student: how grades are posted, the
        // possible points, and the test student, who has no id of the university.
        let mut own = ids.iter().map(|at| (*at, cell(Some(*at))));
        let (column, own) = own.find(|(_, own)| !own.is_empty()).unwrap_or((id, ""));
        let is_test = name == "Student, Test" && (column != ids[0] || ids.len() == 1);
        if own.is_empty() && ["", POINTS_POSSIBLE].contains(&&*name) || is_test {
            continue;
        }
        if own.is_empty() {
            let column = table.name(id);
            return Err(format!(
                "line {line} (`{name}`) has nothing in the column `{column}`"
            ));
        }
        if let Some(other) = people.iter().find(|other| other.id == own) {
            return Err(format!("{} and {name} have the same id, {own}", other.name));
        }
        // Moodle writes `Participant 2001`, or the same in another language.
        let number = cell(number).trim_start_matches(|c: char| !c.is_ascii_digit());
        let is_same = |other: &&Person| other.number.as_deref() == Some(number);
        if let Some(other) = people.iter().find(is_same) {
            return Err(format!(
                "{} and {name} have the same number, {number}",
                other.name
            ));
        }
        let github = cell(github);
        let wrong = || format!("line {line}: `{github}` is not a login on GitHub");
        let github = github_login(github).ok_or_else(wrong)?;
        people.push(Person {
            id: own.to_owned(),
            has_assigned_id: is_assigned(column) && !own.contains('@') && own != github,
            name,
            section: cell(section).into(),
            number: Some(number).filter(|it| !it.is_empty()).map(str::to_owned),
            github: Some(github.to_owned()).filter(|it| !it.is_empty()),
            group: None,
            logins: logins
                .iter()
                .map(|at| cell(Some(*at)).to_owned())
                .filter(|login| !login.is_empty())
                .collect(),
        });
    }
    match people.is_empty() {
        true => Err("it lists nobody".into()),
        false => Ok(people),
    }
}

/// A login on GitHub that may be written as `@login` or as an address, but not as a repository's address.
fn github_login(text: &str) -> Option<&str> {
    let path = text
        .split_once("github.com/")
        .map_or(text, |(_, path)| path);
    let login = path.trim_end_matches('/').trim_start_matches('@');
    (!login.contains('/')).then_some(login)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    fn people(bytes: &[u8]) -> std::result::Result<Vec<Person>, String> {
        Table::of(bytes).and_then(super::people)
    }

    const PLAIN: &str = "id;name;section\r\n7;Zoë Müller;A\r\n8;Ada Lovelace;B\r\n";

    fn is_of_zoe_and_ada(bytes: &[u8]) {
        let people = people(bytes).expect("it is a roster");
        let names: Vec<&str> = people.iter().map(|person| person.name.as_str()).collect();
        assert_eq!(names, ["Zoë Müller", "Ada Lovelace"]);
        assert_eq!(
            (people[1].id.as_str(), people[1].section.as_str()),
            ("8", "B")
        );
    }

    #[test]
    fn rosters_are_read_with_any_separator_and_encoding() {
        let utf16 = |text: &str, begin: &[u8]| -> Vec<u8> {
            let units = text.encode_utf16().flat_map(u16::to_le_bytes);
            begin.iter().copied().chain(units).collect()
        };
        let latin: Vec<u8> = PLAIN.chars().map(|c| c as u32 as u8).collect();
        is_of_zoe_and_ada(PLAIN.as_bytes());
        is_of_zoe_and_ada(PLAIN.replace(';', ",").as_bytes());
        is_of_zoe_and_ada(PLAIN.replace(';', "\t").as_bytes());
        is_of_zoe_and_ada(format!("\u{feff}sep=;\r\n{PLAIN}").as_bytes());
        is_of_zoe_and_ada(&utf16(PLAIN, b"\xff\xfe"));
        is_of_zoe_and_ada(&utf16(PLAIN, b""));
        is_of_zoe_and_ada(&latin);
    }

    #[test]
    fn a_login_is_no_address_and_an_address_on_github_is_a_login() {
        let list = "id,name,email,github\n1,Ada,ada@x.org,@countess\n\
            2,Bob,ada,https://github.com/bob/\n";
        let people = people(list.as_bytes()).expect("it is a roster");
        assert_eq!(people[0].logins, ["ada@x.org"]);
        assert_eq!(people[1].logins, [""; 0], "Bob may have chosen it");
        let github = people.iter().filter_map(|it| it.github.as_deref());
        assert_eq!(github.collect::<Vec<_>>(), ["countess", "bob"]);
        let list = "id,name,github\n1,Ada,https://github.com/ada/bob\n";
        let why = self::people(list.as_bytes()).expect_err("it is a repository");
        assert!(
            why.starts_with("line 2: `https://github.com/ada/bob`"),
            "{why}"
        );
    }

    #[test]
    fn two_people_with_one_number_are_refused() {
        let twins = "id,name,number\n1,Ada,7\n2,Bob,7\n";
        let error = people(twins.as_bytes()).expect_err("nobody knows whose it is");
        assert!(error.contains("the same number, 7"), "{error}");
        assert!(people(twins.replace('7', "").as_bytes()).is_ok());
    }

    #[test]
    fn damaged_rosters_do_not_harm_the_reader() {
        bolero::check!().for_each(|bytes| {
            let people = people(bytes).unwrap_or_default();
            let ids: BTreeSet<&str> = people.iter().map(|person| &*person.id).collect();
            assert_eq!(ids.len(), people.len());
            assert!(!ids.contains(""));
        });
    }

    #[test]
    fn lists_from_platforms_are_rosters() {
        let canvas = "Student,ID,SIS User ID,SIS Login ID,Section,Homework 1 (22)\n\
            ,,,,,Manual Posting\n\
            Points Possible,,,,,100\n\
            \"Lovelace, Ada\",11,20231234,al123,L1,\n\
            \"Student, Test\",99,,5f3c1a,L1,\n\
            \"Student, Test\",12,20231235,al124,L1,\n";
        let mut canvas = people(canvas.as_bytes()).expect("it is a roster");
        assert_eq!(canvas.len(), 2);
        assert_eq!(canvas[1].id, "20231235", "somebody has this name");
        let ada = canvas.remove(0);
        assert_eq!(
            (ada.id.as_str(), ada.number.as_deref()),
            ("20231234", Some("11"))
        );
        assert_eq!(
            (ada.name.as_str(), &ada.logins[..]),
            ("Lovelace, Ada", &["al123".into()][..])
        );
        let moodle = "Identifier,Full name,ID number,Email address\n\
            Participant 2001,Ada Lovelace,20231234,ada@uni.example\n";
        let ada = people(moodle.as_bytes()).expect("it is a roster").remove(0);
        assert_eq!(
            (ada.id.as_str(), ada.number.as_deref()),
            ("20231234", Some("2001"))
        );
        // Moodle in German; one person has no id number.
        let german = "ID;Vollständiger Name;ID-Nummer;E-Mail-Adresse\n\
            Teilnehmer/in2001;Ada Lovelace;20231234;ada@uni.example\n\
            Teilnehmer/in2002;Zoë Müller;;zoe@uni.example\n";
        let german = people(german.as_bytes()).expect("it is a roster");
        let ids = german.iter().map(|person| person.id.as_str());
        assert_eq!(ids.collect::<Vec<_>>(), ["20231234", "Teilnehmer/in2002"]);
        let numbers = german.iter().filter_map(|person| person.number.as_deref());
        assert_eq!(numbers.collect::<Vec<_>>(), ["2001", "2002"]);
        let classroom = "username,first_name,last_name,email,section,github_id\n\
            countess,Ada,Lovelace,,A,1234\n";
        let ada = people(classroom.as_bytes()).expect("it is a roster");
        assert_eq!(
            (ada[0].id.as_str(), ada[0].github.as_deref()),
            ("countess", Some("countess"))
        );
        let classroom = "identifier,github_username,github_id,name\n\
            ada@cs50.edu,countess,1,Ada\nbob@cs50.edu,bob,2,Bob\n";
        let ada = people(classroom.as_bytes()).expect("it is a roster");
        assert_eq!((&*ada[0].id, &ada[0].number), ("ada@cs50.edu", &None));
        let list = "First name,Last name,ID number\nAda,Lovelace,20231234\n";
        let ada = people(list.as_bytes()).expect("it is a roster").remove(0);
        assert_eq!(ada.name, "Ada Lovelace");
    }

    #[test]
    fn only_some_ids_were_assigned_by_the_university() {
        let ada = |list: &str| people(list.as_bytes()).expect("it is a roster").remove(0);
        for list in [
            "id,name\n7,Ada\n",
            "id,name,number\n7,Ada,11\n",
            "Matrikelnummer,Name\n7,Ada\n",
            "Student,ID,SIS User ID\nAda,11,7\n",
            "Identifier,Full name,ID number\nParticipant 11,Ada,7\n",
            "identifier,github_username,name\n7,ada,Ada\n",
        ] {
            assert!(ada(list).has_assigned_id, "{list}");
        }
        for list in [
            "id,name,github\nada,Ada,@ada\n",
            "id,name\nada@x.org,Ada\n",
            "username,name\nada,Ada\n",
            "name,Email address\nAda,ada@x.org\n",
            "username,first_name,github_id\nada,Ada,1\n",
            "identifier,github_username,name\nada,ada,Ada\n",
        ] {
            assert!(!ada(list).has_assigned_id, "{list}");
        }
        // These platforms gave a number instead of an id.
        for list in [
            "Student,ID,SIS User ID\nAda,11,\n",
            "Student,ID,SIS Login ID\nAda,11,al1\n",
            "Student,ID\n    Points Possible,\nAda,11\n",
            "Identifier,Full name,ID number\nParticipant 11,Ada,\n",
        ] {
            let ada = ada(list);
            let number = ada.number.as_deref();
            assert_eq!((ada.has_assigned_id, number), (false, Some("11")), "{list}");
        }
    }

    #[test]
    fn file_that_is_not_a_roster_is_refused_with_a_reason() {
        for (text, why) in [
            (
                "nr,who\n1,Ada\n",
                "its first line is `nr,who`, which has no column `id`",
            ),
            ("id,who\n1,Ada\n", "no column `name`"),
            ("id,name\n1,Ada\n1,Bob\n", "Ada and Bob have the same id, 1"),
            (
                "id,name\n1,Ada\n,Bob\n",
                "line 3 (`Bob`) has nothing in the column `id`",
            ),
            ("id,name\n", "nobody"),
            ("PK\u{3}\u{4}", "export it as CSV"),
        ] {
            let said = people(text.as_bytes()).expect_err(text);
            assert!(said.contains(why), "{said}");
        }
    }

    #[test]
    fn nobody_turns_ids_into_canvas_numbers_by_a_name() {
        for name in ["Eve", POINTS_POSSIBLE] {
            let text = format!("id,name,email address\n7,Ada,ada@x.org\n,{name},eve@x.org\n");
            let people = people(text.as_bytes()).expect("it is a roster");
            assert_eq!((&*people[0].id, &people[0].number), ("7", &None), "{name}");
        }
    }
}
