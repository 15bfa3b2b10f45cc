// SPDX-License-Identifier: MIT
//! The crates as programs of ./dev field: crates NAME INPUT.obj OUTPUT.obj
//!
//! Hulls take the input's points, decomposers its faces, too; each by the call that its documents show. Exit code 4: the
//! crate returned an error or nothing. The seconds of that call go to OUTPUT.obj.json.
use std::fmt::{Debug, Display, Write};
use std::time::Instant;

type Failure = Box<dyn std::error::Error>;
type Hull = (Vec<[f64; 3]>, Vec<[u32; 3]>);

fn read_obj(path: &str) -> Result<Hull, Failure> {
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for line in std::fs::read_to_string(path)?.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.first() {
            Some(&"v") => points.push([words[1].parse()?, words[2].parse()?, words[3].parse()?]),
            Some(&"f") => {
                let corners = words[1..].iter().map(|word| Ok(word.split('/').next().unwrap_or(word).parse::<u32>()? - 1)).collect::<Result<Vec<_>, Failure>>()?;
                faces.extend((2..corners.len()).map(|k| [corners[0], corners[k - 1], corners[k]]));
            }
            _ => {}
        }
    }
    Ok((points, faces))
}

/// An object for each hull; numbers are the shortest that read as the same binary32 or binary64.
fn obj_text<T: Display>(hulls: &[(Vec<[T; 3]>, Vec<[u32; 3]>)]) -> String {
    let (mut text, mut base) = (String::new(), 1);
    for (number, (corners, triangles)) in hulls.iter().enumerate() {
        let _ = writeln!(text, "o part_{number:03}");
        for [x, y, z] in corners {
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        for [a, b, c] in triangles {
            let _ = writeln!(text, "f {} {} {}", a + base, b + base, c + base);
        }
        base += corners.len() as u32;
    }
    text
}

/// Seconds that this thread ran, where the system tells; in steps of some milliseconds.
fn on_processor() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/schedstat").ok()?;
    Some(text.split(' ').next()?.parse::<f64>().ok()? * 1e-9)
}

/// The second of two calls, as the other adapters do; the first one if that took long. Then the processor's time counts if it
/// is less than the clock's, as on a busy machine.
fn timed<R>(seconds: &mut f64, call: impl Fn() -> R) -> R {
    let mut turn = 0;
    loop {
        let (start, used) = (Instant::now(), on_processor());
        let result = call();
        *seconds = start.elapsed().as_secs_f64();
        if let (true, Some(before), Some(after)) = (*seconds > 0.05, used, on_processor()) {
            *seconds = seconds.min(after - before);
        }
        turn += 1;
        if turn == 2 || *seconds > 0.2 {
            return result;
        }
    }
}

fn said(fault: impl Debug) -> Failure {
    format!("{fault:?}").into()
}

// Two crates, one source: parry3d in binary32, parry3d-f64 in binary64.
macro_rules! parry {
    ($module:ident, $package:ident, $real:ty) => {
        mod $module {
            use super::*;
            use $package::math::Vector;
            use $package::transformation::vhacd::{VHACDParameters, VHACD};

            type Found = Vec<(Vec<[$real; 3]>, Vec<[u32; 3]>)>;

            fn vectors(points: &[[f64; 3]]) -> Vec<Vector> {
                points.iter().map(|p| Vector::new(p[0] as $real, p[1] as $real, p[2] as $real)).collect()
            }

            fn plain(hulls: Vec<(Vec<Vector>, Vec<[u32; 3]>)>) -> Found {
                hulls.into_iter().map(|(corners, faces)| (corners.iter().map(|p| [p.x, p.y, p.z]).collect(), faces)).collect()
            }

            pub fn hull((points, _): &Hull, seconds: &mut f64) -> Result<Found, Failure> {
                let points = vectors(points);
                let hull = timed(seconds, || $package::transformation::try_convex_hull(&points)).map_err(said)?;
                Ok(plain(vec![hull]))
            }

            /// The parts' hulls: of the voxels, or of the surface in them.
            #[allow(dead_code)] // of binary64 only the hull is run
            pub fn parts((points, faces): &Hull, exact: bool, seconds: &mut f64) -> Result<Found, Failure> {
                let points = vectors(points);
                Ok(plain(timed(seconds, || {
                    let found = VHACD::decompose(&VHACDParameters::default(), &points, faces, exact);
                    if exact { found.compute_exact_convex_hulls(&points, faces) } else { found.compute_convex_hulls(4) }
                })))
            }
        }
    };
}
parry!(single, parry3d, f32);
parry!(double, parry3d_f64, f64);

fn chull((points, _): &Hull, exact: bool, seconds: &mut f64) -> Result<Vec<Hull>, Failure> {
    let points: Vec<Vec<f64>> = points.iter().map(|p| p.to_vec()).collect();
    let (corners, indices) = if exact {
        timed(seconds, || chull::ConvexHullWrapper::try_new(&points, None)).map_err(said)?.vertices_indices()
    } else {
        timed(seconds, || chull::ConvexHull::try_new(&points, f64::EPSILON * 200.0, None)).map_err(said)?.vertices_indices()
    };
    let triangles = indices.chunks_exact(3).map(|t| [t[0] as u32, t[1] as u32, t[2] as u32]).collect();
    Ok(vec![(corners.iter().map(|p| [p[0], p[1], p[2]]).collect(), triangles)])
}

fn run(name: &str, source: &str, target: &str) -> Result<(), Failure> {
    let (input, mut seconds) = (read_obj(source)?, 0.0);
    let text = match name {
        "parry" => obj_text(&single::hull(&input, &mut seconds)?),
        "parry64" => obj_text(&double::hull(&input, &mut seconds)?),
        "parry-parts" => obj_text(&single::parts(&input, true, &mut seconds)?),
        "parry-voxels" => obj_text(&single::parts(&input, false, &mut seconds)?),
        "chull" => obj_text(&chull(&input, true, &mut seconds)?),
        "chull-fast" => obj_text(&chull(&input, false, &mut seconds)?),
        _ => return Err(format!("no program {name}").into()),
    };
    std::fs::write(target, text)?;
    std::fs::write(format!("{target}.json"), format!("{{\"seconds\": {seconds:e}}}\n"))?;
    Ok(())
}

fn main() {
    let words: Vec<String> = std::env::args().collect();
    if let Err(fault) = run(&words[1], &words[2], &words[3]) {
        eprintln!("{}: {fault}", words[1]);
        std::process::exit(4);
    }
}
