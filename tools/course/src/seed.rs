//! The seed from which questions and random scenes are drawn.

use std::fmt;
use std::num::ParseIntError;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

/// The seed has 128 bits, so that nobody can find it from some of the questions by trying all
/// seeds.
///
/// The scripts hash its decimal digits together with the name of what is drawn. A small number
/// therefore draws the same questions as in earlier versions, which had only small seeds.
#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(try_from = "SeedInToml", into = "SeedInToml")]
pub struct Seed(pub u128);

/// A seed in TOML, whose numbers have 63 bits. A larger seed is written as text.
#[derive(Deserialize, Serialize)]
#[serde(untagged)]
enum SeedInToml {
    Number(i64),
    Text(String),
}

impl From<Seed> for SeedInToml {
    fn from(seed: Seed) -> SeedInToml {
        i64::try_from(seed.0)
            .map_or_else(|_| SeedInToml::Text(seed.to_string()), SeedInToml::Number)
    }
}

impl TryFrom<SeedInToml> for Seed {
    type Error = ParseIntError;

    fn try_from(written: SeedInToml) -> Result<Seed, ParseIntError> {
        match written {
            SeedInToml::Number(number) => number.to_string().parse(),
            SeedInToml::Text(text) => text.parse(),
        }
    }
}

impl FromStr for Seed {
    type Err = ParseIntError;

    fn from_str(digits: &str) -> Result<Seed, ParseIntError> {
        digits.parse().map(Seed)
    }
}

impl fmt::Display for Seed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, Deserialize, PartialEq, Serialize)]
    struct Manifest {
        seed: Option<Seed>,
    }

    #[test]
    fn small_seeds_are_toml_numbers_and_large_seeds_are_strings() {
        for (seed, text) in [
            (1, "seed = 1\n"),
            (i64::MAX as u128, "seed = 9223372036854775807\n"),
            (1 << 63, "seed = \"9223372036854775808\"\n"),
            (
                u128::MAX,
                "seed = \"340282366920938463463374607431768211455\"\n",
            ),
        ] {
            let manifest = Manifest {
                seed: Some(Seed(seed)),
            };
            assert_eq!(toml::to_string(&manifest).unwrap(), text);
            assert_eq!(toml::from_str::<Manifest>(text).unwrap(), manifest);
        }
        for wrong in ["seed = -1", "seed = \"0x7\"", "seed = 1.5"] {
            assert!(toml::from_str::<Manifest>(wrong).is_err(), "{wrong}");
        }
    }
}
