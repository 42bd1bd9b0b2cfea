//! Films as OpenEXR files, through the `exr` crate.
//!
//! The `image` crate reads OpenEXR too, but only red, green, blue and alpha.

use std::fs;
use std::io::Cursor;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use exr::meta::MetaData;
use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, ReadChannels,
    ReadLayers, WritableImage,
};

use super::{Channel, Film};
use crate::camera::Resolution;
use crate::error::Error;

/// The most samples that a film may have in all its channels together. They fill 1 GiB.
const MOST_SAMPLES: usize = 1 << 28;

/// Deflate can't compress data by a larger factor than this, so a file that claims to hold more is
/// damaged or hostile. If we believed it, we would allocate memory that is never filled.
const MOST_COMPRESSION: usize = 1100;

pub(super) fn read(path: &Path) -> Result<Film, Error> {
    let remedy = "write an OpenEXR file with 32-bit float channels; see \"Scene and film files\" in the book";
    let refuse = |problem: String| Error::new(path, problem, remedy);

    // Reading a pipe or a device might never end.
    if fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
        return Err(refuse(
            "cannot read this film: it is not a regular file".into(),
        ));
    }
    let bytes =
        fs::read(path).map_err(|error| refuse(format!("cannot read this film: {error}")))?;
    // The bytes are untrusted, so a panic in the decoder must not end this program.
    let decoded = catch_unwind(AssertUnwindSafe(|| decode(&bytes)));
    let image = match decoded {
        Ok(image) => image.map_err(&refuse)?,
        Err(_) => return Err(refuse("this OpenEXR file is damaged".into())),
    };

    let layer = image.layer_data;
    let window = image.attributes.display_window;
    let origin = (
        layer.attributes.layer_position.x(),
        layer.attributes.layer_position.y(),
    );
    if origin != (0, 0)
        || window.position.x() != 0
        || window.position.y() != 0
        || window.size != layer.size
    {
        return Err(refuse(format!(
            "the data window ({}×{} at {}, {}) is not the whole picture ({}×{})",
            layer.size.x(),
            layer.size.y(),
            origin.0,
            origin.1,
            window.size.x(),
            window.size.y(),
        )));
    }
    let resolution = Resolution {
        n_x: layer.size.x(),
        n_y: layer.size.y(),
    };
    let mut channels = Vec::new();
    for channel in layer.channel_data.list {
        let name = channel.name.to_string();
        if (channel.sampling.x(), channel.sampling.y()) != (1, 1) {
            return Err(refuse(format!(
                "channel `{name}` has fewer samples than the film has pixels"
            )));
        }
        let FlatSamples::F32(samples) = channel.sample_data else {
            return Err(refuse(format!(
                "channel `{name}` does not hold 32-bit floats"
            )));
        };
        channels.push(Channel { name, samples });
    }
    Ok(Film::new(resolution, channels))
}

fn decode(bytes: &[u8]) -> Result<OneLayer, String> {
    let said = |error: exr::error::Error| format!("this is not a readable OpenEXR file: {error}");
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(said)?;
    if meta.requirements.has_deep_data {
        return Err("the file has deep data; a film has one sample for each pixel".into());
    }
    let [header] = meta.headers.as_slice() else {
        return Err(format!(
            "the file holds {} images; a film has only one",
            meta.headers.len()
        ));
    };
    let size = header.layer_size;
    let samples = size.area().saturating_mul(header.channels.list.len());
    if samples > MOST_SAMPLES || samples.saturating_mul(4) / MOST_COMPRESSION > bytes.len() {
        return Err(format!(
            "the file claims to have {}×{} pixels with {} channels, but is too small to hold them",
            size.x(),
            size.y(),
            header.channels.list.len(),
        ));
    }
    exr::image::read::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        // Refuse a damaged table of blocks, as other programs do, instead of reading around it.
        .pedantic()
        .from_buffered(Cursor::new(bytes))
        .map_err(said)
}

type OneLayer = Image<Layer<AnyChannels<FlatSamples>>>;

/// The bytes of a film, or why there are none.
pub(super) fn to_bytes(film: &Film) -> Result<Vec<u8>, String> {
    let list = film.channels.iter().map(|channel| {
        AnyChannel::new(
            channel.name.as_str(),
            FlatSamples::F32(channel.samples.clone()),
        )
    });
    let layer = Layer::new(
        (film.resolution.n_x, film.resolution.n_y),
        LayerAttributes::default(),
        Encoding::SMALL_LOSSLESS,
        AnyChannels::sort(list.collect()),
    );
    // One thread writes compressed blocks in the same order every time, so the file is always the
    // same.
    let mut bytes = Cursor::new(Vec::new());
    Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(&mut bytes)
        .map_err(|error| error.to_string())?;
    Ok(bytes.into_inner())
}
