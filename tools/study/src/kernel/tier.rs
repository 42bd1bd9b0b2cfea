use serde::{Deserialize, Serialize};

/// What has the last word in an exact kernel, from cheap to dear. (A whole scene has a tier
/// before these, a static filter: its bounds are known before the ray is.) The names are the field's
/// (Shewchuk 1997; Brönnimann, Burnikel & Pion, "Interval arithmetic yields efficient dynamic
/// filters for computational geometry", *Discrete Applied Mathematics* 109, 2001).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Tier {
    /// An error bound computed from this ray and this shape.
    #[serde(rename = "semi-static filter")]
    SemiStatic,
    /// Twice the digits, with an error bound.
    #[serde(rename = "double-double")]
    DoubleDouble,
    /// Whole numbers of any length.
    #[serde(rename = "exact")]
    Exact,
}

impl Tier {
    /// How tables call it.
    pub fn name(self) -> &'static str {
        match self {
            Tier::SemiStatic => "semi-static filter",
            Tier::DoubleDouble => "double-double",
            Tier::Exact => "exact",
        }
    }
}
