//! The error curves as a picture.

use std::error::Error;

use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use reduction::Curve;
use skeleton::Representation;

/// Width and height. A picture of lines has no pixels, but plotters places everything on whole ones: many make curves smooth.
/// It is shown at half this size, so that it fits into a window.
const SIZE: (u32, u32) = (1600, 1500);
/// The height of the title and the upper curves.
const UPPER: u32 = 850;
/// The size of texts.
const TEXT: u32 = 36;
/// Lines are made of at most about so many points.
const POINTS: usize = 1500;
/// So many times ten to one is the most that is shown of errors of very different sizes.
const DECADES: f64 = 9.0;

/// Blue and vermilion of M. Okabe and K. Ito, which people tell apart whatever colours they see.
const BLUE: RGBColor = RGBColor(0, 114, 178);
const VERMILION: RGBColor = RGBColor(213, 94, 0);

/// Draws the accumulated error over the number of interpolated frames, for both representations, as SVG: above as it is, and
/// below on a logarithmic scale, which shows small errors as well as large ones. `title` is the name of the motion, which has so many
/// frames.
///
/// # Errors
///
/// When an error is infinite or no number: nothing can be drawn of it.
pub fn svg(title: &str, frame_count: usize, euler: &Curve, quaternions: &Curve) -> Result<String, String> {
    let curves = [euler, quaternions];
    if !curves.iter().flat_map(|curve| &curve.errors).all(|error| error.is_finite()) {
        return Err("the errors are too large to be drawn: they are not finite numbers".into());
    }
    let mut text = String::new();
    draw(&mut text, title, frame_count, curves).map_err(|error| error.to_string())?;
    Ok(text.replacen(&size_of(SIZE), &size_of((SIZE.0 / 2, SIZE.1 / 2)), 1))
}

/// The attributes that say how large a picture is shown. The viewBox keeps the size in which it was drawn.
fn size_of((width, height): (u32, u32)) -> String {
    format!("width=\"{width}\" height=\"{height}\"")
}

fn draw(
    text: &mut String,
    title: &str,
    frame_count: usize,
    curves: [&Curve; 2],
) -> Result<(), Box<dyn Error>> {
    let area = SVGBackend::with_string(text, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let largest = curves.iter().flat_map(|curve| &curve.errors).copied().fold(0.0, f64::max);
    let (unit, unit_name) = unit(largest);
    let (upper, lower) = area.split_vertically(UPPER);
    let upper = upper.titled(title, ("sans-serif", TEXT * 5 / 4))?;
    let frames = format!("interpolated frames, of {frame_count}");
    // Rounding must not bring a curve below the ground.
    Panel {
        curves: curves.map(|curve| points(curve).map(|(x, y)| (x, (y / unit).max(0.0))).collect()),
        ground: 0.0,
        top: if largest > 0.0 { largest / unit * 1.05 } else { 1.0 },
        titles: [&frames, &format!("accumulated error ({unit_name})")],
        label: shortest,
        has_legend: true,
    }
    .draw(&upper)?;

    let ground = largest * 10_f64.powf(-DECADES);
    let shown = curves.map(|curve| {
        let positive = points(curve).filter(|(_, error)| *error > ground);
        positive.map(|(x, error)| (x, error.log10())).collect::<Vec<_>>()
    });
    let lowest = shown.iter().flatten().map(|point| point.1).fold(f64::INFINITY, f64::min);
    let (ground, top) = match lowest.is_finite() {
        true => (lowest - 0.1, largest.log10() + 0.2),
        false => (0.0, 1.0),
    };
    let titles = [&*frames, "squared file units, logarithmic"];
    Panel { curves: shown, ground, top, titles, label: power, has_legend: false }.draw(&lower)?;
    area.present()?;
    Ok(())
}

/// One pair of axes with both curves.
struct Panel<'a> {
    /// Points, Euler angles first.
    curves: [Vec<(f64, f64)>; 2],
    ground: f64,
    top: f64,
    /// Of the axis to the right, and of the one upwards.
    titles: [&'a str; 2],
    /// What stands at the axis that goes upwards.
    label: fn(f64) -> String,
    has_legend: bool,
}

impl Panel<'_> {
    fn draw(self, area: &DrawingArea<SVGBackend, Shift>) -> Result<(), Box<dyn Error>> {
        let Panel { curves: [euler, quaternions], ground, top, titles, label, has_legend } = self;
        // Some room for curves without a point.
        let right = euler.iter().chain(&quaternions).map(|point| point.0).fold(1.0, f64::max);
        let mut chart = ChartBuilder::on(area)
            .margin(TEXT)
            .x_label_area_size(TEXT * 5 / 2)
            .y_label_area_size(TEXT * 7 / 2)
            .build_cartesian_2d(0.0..right, ground..top)?;
        chart
            .configure_mesh()
            .label_style(("sans-serif", TEXT))
            .axis_desc_style(("sans-serif", TEXT))
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .axis_style(BLACK.mix(0.6))
            .x_labels(8)
            .y_labels(6)
            .x_label_formatter(&|x| shortest(*x))
            .y_label_formatter(&|y| label(*y))
            .x_desc(titles[0])
            .y_desc(titles[1])
            .draw()?;

        let (dash, gap) = (22, 14);
        // As in the window: quaternions are the dashed blue line.
        let solid = ShapeStyle::from(VERMILION).stroke_width(4);
        let dashed = ShapeStyle::from(BLUE).stroke_width(5);
        chart
            .draw_series(LineSeries::new(euler, solid))?
            .label(Representation::Euler.name())
            .legend(move |(x, y)| PathElement::new(vec![(x, y), (x + 96, y)], solid));
        chart
            .draw_series(DashedLineSeries::new(quaternions, dash, gap, dashed))?
            .label(Representation::Quaternion.name())
            .legend(move |(x, y)| DashedPathElement::new(vec![(x, y), (x + 96, y)], dash, gap, dashed));
        if has_legend {
            chart
                .configure_series_labels()
                .position(SeriesLabelPosition::UpperLeft)
                .margin(TEXT as i32)
                .legend_area_size(108)
                .label_font(("sans-serif", TEXT))
                .background_style(WHITE.mix(0.9))
                .draw()?;
        }
        Ok(())
    }
}

/// The points of a curve. Of very many, some are left out: no two of them could be told apart.
fn points(curve: &Curve) -> impl Iterator<Item = (f64, f64)> + '_ {
    let step = curve.errors.len().div_ceil(POINTS).max(1);
    let last = curve.errors.len().saturating_sub(1);
    let all = curve.errors.iter().enumerate();
    let kept = all.filter(move |(index, _)| index % step == 0 || *index == last);
    kept.map(|(index, error)| (index as f64, *error))
}

/// A unit in which `largest` is a number of one to three digits before the point, and its name.
fn unit(largest: f64) -> (f64, String) {
    let thousands = if largest > 0.0 { (largest.log10() / 3.0).floor() as i32 } else { 0 };
    let name = match thousands {
        0 => "squared file units".to_owned(),
        1 => "thousands of squared file units".to_owned(),
        2 => "millions of squared file units".to_owned(),
        more => format!("10{} squared file units", superscript(3 * more)),
    };
    (10_f64.powi(3 * thousands), name)
}

fn superscript(number: i32) -> String {
    let digit = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32(digit.to_digit(10).unwrap_or(0) + u32::from('⁰')).unwrap_or(digit),
    };
    number.to_string().chars().map(digit).collect()
}

/// A number at an axis, without the digits that rounding leaves behind.
fn shortest(number: f64) -> String {
    ((number * 1e6).round() / 1e6).to_string()
}

/// The number whose logarithm stands at an axis.
fn power(logarithm: f64) -> String {
    let exponent = logarithm.round();
    match (logarithm - exponent).abs() < 1e-6 {
        true if (-3.0..=3.0).contains(&exponent) => shortest(10_f64.powf(exponent)),
        true => format!("10{}", superscript(exponent as i32)),
        false => format!("{:.1e}", 10_f64.powf(logarithm)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(errors: &[f64]) -> Curve {
        Curve { removed: (1..errors.len()).collect(), errors: errors.to_vec() }
    }

    #[test]
    fn a_picture_has_both_curves_in_their_colours_and_says_what_is_what() {
        let errors: Vec<f64> = (0..120).map(|n| f64::from(n).powi(2)).collect();
        let text = svg("a <dance> & \"more\"", 141, &curve(&errors), &curve(&errors[..100])).unwrap();
        for part in [
            "<svg width=\"800\" height=\"750\" viewBox=\"0 0 1600 1500\"",
            "#0072B2",
            "#D55E00",
            "quaternions",
            "Euler angles",
            "interpolated frames, of 141",
            "accumulated error (thousands of squared file units)",
            "a &lt;dance&gt; &amp; &quot;more&quot;",
            "</svg>",
        ] {
            assert!(text.contains(part), "{part} is missing");
        }
        // The dashes are many lines, the other curve is one.
        assert!(text.matches("#0072B2").count() > 20 && text.matches("#D55E00").count() == 3);
    }

    #[test]
    fn whatever_can_be_drawn_is_drawn_and_small() {
        let long: Vec<f64> = (0..200_000).map(f64::from).collect();
        for errors in [&[][..], &[0.0], &[0.0, 0.0], &[0.0, 1e-300], &[0.0, 1e300], &[0.0, -1e-9, 3.0], &long]
        {
            let text = svg("odd", errors.len(), &curve(errors), &curve(errors)).unwrap();
            assert!(text.contains("</svg>") && text.len() < 1 << 18, "{}", text.len());
        }
        for bad in [f64::NAN, f64::INFINITY] {
            assert!(svg("odd", 2, &curve(&[0.0, bad]), &curve(&[0.0])).unwrap_err().contains("not finite"));
        }
    }

    #[test]
    fn units_keep_numbers_short() {
        assert_eq!(unit(999.0), (1.0, "squared file units".into()));
        assert_eq!(unit(1000.0), (1e3, "thousands of squared file units".into()));
        assert_eq!(unit(2.5e12).1, "10¹² squared file units");
        assert_eq!(unit(0.025).1, "10⁻³ squared file units");
        assert_eq!(unit(0.0).0, 1.0);
        let powers =
            [(-2.0, "0.01"), (0.0, "1"), (3.0, "1000"), (4.0, "10⁴"), (-12.0, "10⁻¹²"), (0.5, "3.2e0")];
        for (logarithm, text) in powers {
            assert_eq!(power(logarithm), text);
        }
    }
}
