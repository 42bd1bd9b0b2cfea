//! One pixel of a film that holds questions: its samples by channel name, each of them
//! checked.

use glam::DVec3;

use super::Film;
use crate::bounds::BoundingBox;
use crate::camera::Pixel;
use crate::ray::Ray;

/// The samples of one pixel.
#[derive(Clone, Copy)]
pub(crate) struct Samples<'a> {
    film: &'a Film,
    index: usize,
}

impl<'a> Samples<'a> {
    /// The samples at `index`, in image order.
    pub fn at(film: &'a Film, index: usize) -> Samples<'a> {
        Samples { film, index }
    }

    fn pixel(self) -> Pixel {
        self.film.resolution().pixel(self.index)
    }

    /// The finite number in this channel.
    pub fn number(self, name: &str) -> Result<f64, String> {
        let channel = self.film.channel(name);
        let samples = channel.ok_or_else(|| format!("it has no channel `{name}`"))?;
        match samples[self.index] {
            value if value.is_finite() => Ok(f64::from(value)),
            _ => Err(format!(
                "channel `{name}` is not finite at {}",
                self.pixel()
            )),
        }
    }

    /// The whole number in this channel, 0 or more.
    pub fn count(self, name: &str) -> Result<usize, String> {
        match self.number(name)? {
            value if value >= 0.0 && value.fract() == 0.0 => Ok(value as usize),
            value => Err(format!(
                "channel `{name}` holds {value}, which is not a count"
            )),
        }
    }

    /// The vector in the channels `NAME.X`, `NAME.Y`, `NAME.Z`.
    pub fn vector(self, name: &str) -> Result<DVec3, String> {
        let axis = |axis| self.number(&format!("{name}.{axis}"));
        Ok(DVec3::new(axis("X")?, axis("Y")?, axis("Z")?))
    }

    /// The ray from `O` along `D`.
    pub fn ray(self) -> Result<Ray, String> {
        Ok(Ray {
            origin: self.vector("O")?,
            direction: self.vector("D")?,
        })
    }

    /// The box in the channels `NAME.min.X` to `NAME.max.Z`.
    pub fn bounding_box(self, name: &str) -> Result<BoundingBox, String> {
        let corner = |corner| self.vector(&format!("{name}.{corner}"));
        Ok(BoundingBox {
            min: corner("min")?,
            max: corner("max")?,
        })
    }

    /// The smallest t at which an intersection counts.
    pub fn min_t(self) -> Result<f64, String> {
        match self.number("min_t")? {
            min_t if min_t < 0.0 => Err(format!(
                "channel `min_t` holds {min_t}, behind the ray's origin"
            )),
            min_t => Ok(min_t),
        }
    }
}
