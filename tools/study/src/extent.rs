//! How much work a study does.

/// The part of a study that can be run alone.
#[derive(Clone, Copy, Debug, PartialEq, clap::ValueEnum)]
pub enum Part {
    /// Questions of every kind, and how long each way takes.
    Classes,
    /// Rays at edges and corners of closed meshes.
    Mesh,
    /// Rays that begin on a surface.
    Secondary,
    /// Plans: for each scene, the fastest way to cast its rays that is accurate enough.
    Plans,
    /// Whole scenes.
    Scenes,
    /// Meshes of up to a million triangles, beside Embree.
    Embree,
}

/// How much work a study does.
#[derive(Clone, Debug)]
pub struct Extent {
    /// `quick` or `full`.
    pub name: &'static str,
    /// The only part to run; `None` for all.
    pub only: Option<Part>,
    /// The seed of random questions.
    pub seed: u64,
    /// Questions at each exponent of a family.
    pub questions: usize,
    /// Rays at edges, and as many at vertices.
    pub mesh_rays: usize,
    /// Rays that begin on a surface.
    pub secondary: usize,
    /// Of every scene, every `step`-th ray is cast; 1 for all.
    pub step: usize,
    /// How long each kernel, and each way to cast a scene, is timed.
    pub seconds: f64,
    /// Whether instructions are counted.
    pub instructions: bool,
    /// Random scenes that are planned.
    pub random_plans: u64,
    /// The sizes of the bumpy balls that are cast beside Embree: for each n, one of 8n² triangles.
    pub balls: &'static [u32],
    /// The accuracies that plans are made for.
    pub accuracies: &'static [f64],
}

impl Extent {
    /// The quick study, which takes less than a minute.
    pub const QUICK: Extent = Extent {
        name: "quick",
        questions: 600,
        mesh_rays: 10_000,
        secondary: 2_000,
        step: 7,
        seconds: 0.01,
        instructions: false,
        random_plans: 500,
        balls: &[94],
        accuracies: &[1e-2, 1e-6, 1e-12],
        ..Extent::FULL
    };
    /// The full study, as recorded in `tools/study/record`.
    pub const FULL: Extent = Extent {
        name: "full",
        only: None,
        seed: 20_261_121,
        questions: 4_000,
        mesh_rays: 300_000,
        secondary: 200_000,
        step: 1,
        seconds: 0.15,
        instructions: true,
        random_plans: 10_000,
        balls: &[94, 354],
        accuracies: &[1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12],
    };

    /// Whether a part is run.
    pub fn has(&self, part: Part) -> bool {
        self.only.is_none_or(|only| only == part)
    }
}
