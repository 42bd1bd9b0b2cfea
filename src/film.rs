//! Films: the result of a cast, with one sample per pixel and channel.

use std::fs;
use std::path::Path;

use glam::DVec3;

use crate::bounds::BoundingBox;
use crate::camera::Resolution;
use crate::error::Error;
use crate::ray::{Hit, Intersection, Ray};
use crate::tree::TreeMeasures;

mod openexr;
mod samples;

pub(crate) use samples::Samples;

/// The channels of a film of hits: object id (−1 for none), t, unit normal.
pub const HIT_CHANNELS: [&str; 5] = ["id", "t", "N.X", "N.Y", "N.Z"];

/// The channels of a ray film: origin and direction.
pub const RAY_CHANNELS: [&str; 6] = ["O.X", "O.Y", "O.Z", "D.X", "D.Y", "D.Z"];

/// The channels of a film of boxes: their corners.
pub const BOX_CHANNELS: [&str; 6] = ["min.X", "min.Y", "min.Z", "max.X", "max.Y", "max.Z"];

/// The channels of a film about trees; see [`TreeMeasures`].
pub const TREE_CHANNELS: [&str; 4] = ["misplaced", "depth", "leaf", "cost"];

/// The channel that counts tests. Some films have it in addition to the channels of hits.
pub const TESTS: &str = "tests";

/// The id of a pixel whose ray hits nothing.
pub const MISS: f32 = -1.0;

/// A grid of pixels with named channels of 32-bit floats, which is what OpenEXR files hold.
/// Samples are in image order: rows from the **top**.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    resolution: Resolution,
    /// Sorted by name, because a question about a tree may have hundreds.
    channels: Vec<Channel>,
}

/// One number per pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// The name, as in the file, case included.
    pub name: String,
    /// The samples, in image order; see [`Resolution::pixel`].
    pub samples: Vec<f32>,
}

impl Film {
    /// A film of these channels.
    ///
    /// # Panics
    /// If a channel does not have exactly one sample per pixel.
    pub fn new(resolution: Resolution, mut channels: Vec<Channel>) -> Film {
        let complete = |channel: &Channel| channel.samples.len() == resolution.pixels();
        assert!(
            channels.iter().all(complete),
            "a channel needs one sample per pixel"
        );
        channels.sort_by(|a, b| a.name.cmp(&b.name));
        Film {
            resolution,
            channels,
        }
    }

    /// The film of these hits, in image order. A miss becomes id −1, t 0, normal 0.
    pub fn of_hits(resolution: Resolution, hits: &[Option<Hit>]) -> Film {
        let samples = hits.iter().map(|hit| match hit {
            None => [MISS, 0.0, 0.0, 0.0, 0.0],
            Some(Hit {
                object,
                intersection: at,
            }) => {
                let [x, y, z] = at.normal.as_vec3().to_array();
                [*object as f32, at.t as f32, x, y, z]
            }
        });
        Film::from_samples(resolution, HIT_CHANNELS, samples)
    }

    /// The film of these rays, in image order.
    pub fn of_rays(resolution: Resolution, rays: &[Ray]) -> Film {
        let samples = rays.iter().map(|ray| {
            let ([a, b, c], [d, e, f]) = (
                ray.origin.as_vec3().to_array(),
                ray.direction.as_vec3().to_array(),
            );
            [a, b, c, d, e, f]
        });
        Film::from_samples(resolution, RAY_CHANNELS, samples)
    }

    /// The film of these boxes, in image order.
    pub fn of_boxes(resolution: Resolution, boxes: &[BoundingBox]) -> Film {
        let samples = boxes.iter().map(|bounds| {
            let [min, max] = [bounds.min, bounds.max].map(|corner| corner.as_vec3().to_array());
            [min[0], min[1], min[2], max[0], max[1], max[2]]
        });
        Film::from_samples(resolution, BOX_CHANNELS, samples)
    }

    /// The film of these trees' measures, in image order.
    pub fn of_trees(resolution: Resolution, trees: &[TreeMeasures]) -> Film {
        let samples = trees.iter().map(|tree| {
            let counts = [tree.misplaced, tree.depth, tree.largest_leaf];
            let [misplaced, depth, leaf] = counts.map(|count| count as f32);
            [misplaced, depth, leaf, tree.cost as f32]
        });
        Film::from_samples(resolution, TREE_CHANNELS, samples)
    }

    /// This film with one more channel.
    ///
    /// # Panics
    /// If the channel does not have exactly one sample per pixel.
    pub fn with(mut self, name: &str, samples: Vec<f32>) -> Film {
        let name = name.into();
        self.channels.push(Channel { name, samples });
        Film::new(self.resolution, self.channels)
    }

    fn from_samples<const N: usize>(
        resolution: Resolution,
        names: [&str; N],
        samples: impl Iterator<Item = [f32; N]>,
    ) -> Film {
        let mut channels = names.map(|name| Channel {
            name: name.into(),
            samples: Vec::with_capacity(resolution.pixels()),
        });
        for pixel in samples {
            for (channel, sample) in channels.iter_mut().zip(pixel) {
                channel.samples.push(sample);
            }
        }
        Film::new(resolution, channels.into())
    }

    /// How many pixels it has.
    pub fn resolution(&self) -> Resolution {
        self.resolution
    }

    /// All channels, sorted by name.
    pub fn channels(&self) -> &[Channel] {
        &self.channels
    }

    /// The samples of the channel of this name, in image order.
    pub fn channel(&self, name: &str) -> Option<&[f32]> {
        let found = (self.channels).binary_search_by(|channel| channel.name.as_str().cmp(name));
        found.ok().map(|at| self.channels[at].samples.as_slice())
    }

    /// What a film of hits shows at `index`: the inverse of [`of_hits`](Film::of_hits). A missing
    /// channel counts as 0.
    pub fn hit(&self, index: usize) -> Option<Hit> {
        let id = self.sample("id", index);
        let intersection = Intersection {
            t: self.sample("t", index),
            normal: self.vector("N", index),
        };
        (id >= 0.0).then_some(Hit {
            object: id as usize,
            intersection,
        })
    }

    /// What a film of rays shows at `index`: the inverse of [`of_rays`](Film::of_rays). A missing
    /// channel counts as 0.
    pub fn ray(&self, index: usize) -> Ray {
        Ray {
            origin: self.vector("O", index),
            direction: self.vector("D", index),
        }
    }

    /// What a film of boxes shows at `index`: the inverse of [`of_boxes`](Film::of_boxes). A
    /// missing channel counts as 0.
    pub fn bounding_box(&self, index: usize) -> BoundingBox {
        BoundingBox {
            min: self.vector("min", index),
            max: self.vector("max", index),
        }
    }

    /// What a film about trees shows at `index`: the inverse of [`of_trees`](Film::of_trees). A
    /// missing channel counts as 0.
    pub fn tree(&self, index: usize) -> TreeMeasures {
        let [misplaced, depth, leaf, cost] = TREE_CHANNELS.map(|name| self.sample(name, index));
        TreeMeasures {
            misplaced: misplaced as usize,
            depth: depth as usize,
            largest_leaf: leaf as usize,
            cost,
        }
    }

    fn vector(&self, name: &str, index: usize) -> DVec3 {
        let axis = |axis| self.sample(&format!("{name}.{axis}"), index);
        DVec3::new(axis("X"), axis("Y"), axis("Z"))
    }

    fn sample(&self, channel: &str, index: usize) -> f64 {
        let samples = self.channel(channel);
        samples.map_or(0.0, |samples| f64::from(samples[index]))
    }

    /// Reads an OpenEXR file.
    ///
    /// # Errors
    /// If the file cannot be read, or is not a single flat image of full-size channels whose
    /// data window begins at (0, 0).
    pub fn read(path: &Path) -> Result<Film, Error> {
        openexr::read(path)
    }

    /// Writes an OpenEXR file: 32-bit floats, lossless. Folders must exist.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        let bytes = self.to_bytes();
        let written = bytes.and_then(|it| fs::write(path, it).map_err(|error| error.to_string()));
        written.map_err(|problem| {
            Error::new(
                path,
                format!("cannot write this film: {problem}"),
                "name a folder you may write to",
            )
        })
    }

    /// The bytes of the file that [`write`](Film::write) writes. An error says why there are none.
    pub fn to_bytes(&self) -> Result<Vec<u8>, String> {
        openexr::to_bytes(self)
    }
}

#[cfg(test)]
mod tests;
