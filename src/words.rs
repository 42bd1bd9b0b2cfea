//! Numbers, vectors, rays and hits in words.

use glam::DVec3;

use crate::ray::{Hit, Ray};

/// A number with at most this many significant digits, no trailing zeros, and a real
/// minus sign.
///
/// ```
/// use pinhole::words::number;
///
/// assert_eq!(number(-0.25, 6), "−0.25");
/// assert_eq!(number(1.0 / 3.0, 3), "0.333");
/// ```
pub fn number(value: f64, digits: usize) -> String {
    let text = match value.abs() {
        0.0 => "0".into(),
        size if (1e-4..1e7).contains(&size) => {
            let decimals = (digits as i32 - 1 - size.log10().floor() as i32).max(0) as usize;
            let text = format!("{value:.decimals$}");
            match text.contains('.') {
                true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
                false => text,
            }
        }
        size if size.is_finite() => {
            let text = format!("{value:.*e}", digits.saturating_sub(1));
            let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            let mantissa = match mantissa.contains('.') {
                true => mantissa.trim_end_matches('0').trim_end_matches('.'),
                false => mantissa,
            };
            format!("{mantissa}e{exponent}")
        }
        _ => value.to_string(),
    };
    text.replace('-', "−")
}

/// "(0.5, 1, −2)".
pub fn vector(vector: DVec3, digits: usize) -> String {
    let [x, y, z] = vector.to_array().map(|value| number(value, digits));
    format!("({x}, {y}, {z})")
}

/// "e = (0, 0, 0), d = (0, 0, −1)".
pub fn ray(ray: &Ray, digits: usize) -> String {
    format!(
        "e = {}, d = {}",
        vector(ray.origin, digits),
        vector(ray.direction, digits)
    )
}

/// "object 2 at t = 3.2, normal (0, 1, 0)", or "no hit".
pub fn hit(hit: Option<Hit>, digits: usize) -> String {
    match hit {
        Some(hit) => format!(
            "object {} at {}",
            hit.object,
            intersection(Some(hit), digits)
        ),
        None => intersection(None, digits),
    }
}

/// A hit without its object: "t = 3.2, normal (0, 1, 0)".
pub fn intersection(hit: Option<Hit>, digits: usize) -> String {
    match hit {
        Some(Hit {
            intersection: at, ..
        }) => format!(
            "t = {}, normal {}",
            number(at.t, digits),
            vector(at.normal, digits)
        ),
        None => "no hit".into(),
    }
}

#[cfg(test)]
mod tests;
