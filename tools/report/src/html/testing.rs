//! Films for the tests of reports.

use pinhole::film::{Channel, HIT_CHANNELS};
use pinhole::judge::Golden;
use pinhole::{Film, Resolution};

use pinhole_course::diagnosis::Explanation;
use pinhole_course::mistake::{Hint, Mistake};

/// A film of one row: id, t and normal of each pixel.
pub fn film(pixels: &[[f32; 5]]) -> Film {
    let resolution = Resolution {
        n_x: pixels.len(),
        n_y: 1,
    };
    let channel = |(k, name): (usize, &str)| Channel {
        name: name.into(),
        samples: pixels.iter().map(|pixel| pixel[k]).collect(),
    };
    let channels = HIT_CHANNELS.into_iter().enumerate().map(channel);
    Film::new(resolution, channels.collect())
}

/// A golden of one row with the same tolerance everywhere but in the id.
pub fn golden(pixels: &[[f32; 5]], tolerance: f32) -> Golden {
    let [t, n] = [tolerance; 2];
    let allowed = vec![[0.0, t, n, n, n]; pixels.len()];
    Golden::new(film(pixels), film(&allowed)).expect("the two belong together")
}

/// A belief that explains this share of the errors.
pub fn belief(words: &str, explained: f64) -> Explanation {
    Explanation {
        slug: "made_up".into(),
        mistake: Mistake {
            belief: words.into(),
            fails: vec!["sphere".into()],
            submissions: Some(17),
            chapter: "Sphere".into(),
            beliefs: Vec::new(),
            hint: Hint {
                look: "Look at the rim.".into(),
                think: "What does a ray meet on its way out?".into(),
                example: Some("The roots are −2 and 2.".into()),
                read: "Which root counts".into(),
            },
        },
        explained,
    }
}
