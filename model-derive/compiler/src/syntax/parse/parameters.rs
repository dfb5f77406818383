//! Parameters and coordinates, each with its unit and what follows it.

use syn::Token;
use syn::parse::ParseStream;

use super::blocks::parse_block;
use super::directions::{parse_direction, set_once};
use super::docs::{Supported, parse_docs, parse_rust_attributes};
use super::domains::{parse_comparison, parse_interval};
use super::names::{parse_declared, reserved};
use super::tokens::{expected, parse_colon, parse_semicolon, parse_text};
use super::units::parse_unit;
use crate::report::{Report, error};
use crate::states::States;
use crate::syntax::tree::{Coordinate, Declaration, Parameter};

/// `parameters { … }`, behind its first word.
pub fn parse_parameters(input: ParseStream<'_>, model: &mut Declaration, report: &mut Report) -> syn::Result<()> {
    parse_block(input, "the parameters", report, starts_quantity, |input, report| parse_parameter(input, model, report))
}

/// `lam "λ": rad, in (-pi/2, pi/2);`
///
/// One that cannot be read to its end is there all the same: what uses it is no further mistake.
fn parse_parameter(input: ParseStream<'_>, model: &mut Declaration, report: &mut Report) -> syn::Result<()> {
    let what = "the name of a parameter";
    let (docs, rust_attributes) = parse_rust_attributes(input, what, Supported::Rust, report)?;
    let name = parse_declared(input, what)?;
    let reserved = reserved(&name.to_string());
    let bounds = Vec::new();
    let (direction, gravity, speed, unused) = (None, None, None, None);
    let mut parameter =
        Parameter { docs, rust_attributes, name, symbol: None, unit: None, bounds, direction, gravity, speed, unused };
    // Of one that is only half read nothing should follow.
    let read = parse_after_name(input, &mut parameter).inspect_err(|_| parameter.unit = None);
    match reserved {
        None if parameter.speed.is_some() => take_speed(parameter, model, report),
        None => model.parameters.push(parameter),
        // It could not become a field.
        Some(what) => {
            report.error(&parameter.name, format!("`{}` is {what}: expected another name", parameter.name));
            model.unread.push(parameter.name);
        }
    }
    read
}

/// `v: m/s, speed;` is read among the parameters, but is none: it has no value in a set, and no field.
fn take_speed(speed: Parameter, model: &mut Declaration, report: &mut Report) {
    let name = &speed.name;
    if let Some(span) = speed.speed.filter(|_| model.speed.is_some()) {
        report.error(span, "a second `speed`: expected one name for the forward speed");
    }
    if let Some(bound) = speed.bounds.first() {
        let message = format!(
            "a domain of the speed `{name}`: expected none, since its values are not those of a parameter; eigenvalues are \
             asked for at any"
        );
        report.error(bound.region, message);
    }
    for (span, word) in [(speed.gravity, "gravity"), (speed.unused, "unused")] {
        if let Some(span) = span {
            report.error(span, format!("`{name}` is the speed: expected no `{word}` beside it"));
        }
    }
    model.speed.get_or_insert(speed);
}

fn parse_after_name(input: ParseStream<'_>, parameter: &mut Parameter) -> syn::Result<()> {
    parameter.symbol = parse_text(input)?;
    parse_colon(input, "`:` and a unit")?;
    parameter.unit = Some(parse_unit(input)?);
    while input.parse::<Option<Token![,]>>()?.is_some() {
        if let Some(bound) = parse_comparison(input)? {
            parameter.bounds.push(bound);
        } else if input.peek(Token![in]) {
            parameter.bounds.extend(parse_interval(input)?);
        } else if let Some((span, direction)) = parse_direction(input)? {
            set_once(&mut parameter.direction, direction, span)?;
        } else if input.peek(syn::Ident) {
            let word: syn::Ident = input.parse()?;
            match word.to_string().as_str() {
                "gravity" => parameter.gravity = Some(word.span()),
                "speed" => parameter.speed = Some(word.span()),
                "unused" => parameter.unused = Some(word.span()),
                other => return Err(error(&word, format!("found `{other}`: expected {AFTER_UNIT}"))),
            }
        } else {
            return Err(expected(input, AFTER_UNIT));
        }
    }
    let plain = parameter.bounds.is_empty() && parameter.direction.is_none();
    parse_semicolon(input, if plain { "`*`, `/`, `,` or `;`" } else { "`,` or `;`" }, "the parameter")
}

/// What may follow the unit of a parameter.
const AFTER_UNIT: &str = "a domain (`> 0`, `>= 0`, `!= 0`, `in (a, b)`, `in [a, b]`), \
                          a direction (`along x`, `about y`), `gravity`, `speed` or `unused`";

/// `coordinates { … }`, behind its first word.
pub fn parse_coordinates(
    input: ParseStream<'_>,
    keyword: &syn::Ident,
    model: &mut Declaration,
    report: &mut Report,
) -> syn::Result<()> {
    let mut second = Vec::new();
    let coordinates = if model.coordinates.is_empty() {
        &mut model.coordinates
    } else {
        report.error(keyword, "a second `coordinates`: expected one, since its order is that of the matrices");
        &mut second
    };
    parse_block(input, "the coordinates", report, starts_quantity, |input, report| {
        parse_coordinate(input, coordinates, report)
    })
}

/// `phi "lean": rad, about x;`, there all the same if it cannot be read to its end.
fn parse_coordinate(input: ParseStream<'_>, coordinates: &mut Vec<Coordinate>, report: &mut Report) -> syn::Result<()> {
    let what = "the name of a coordinate";
    let docs = parse_docs(input, what, report)?;
    let name = parse_declared(input, what)?;
    coordinates.push(Coordinate { docs, name, label: None, unit: None, direction: None, only: None });
    let Some(coordinate) = coordinates.last_mut() else { return Ok(()) };
    parse_after_label(input, coordinate).inspect_err(|_| coordinate.unit = None)
}

fn parse_after_label(input: ParseStream<'_>, coordinate: &mut Coordinate) -> syn::Result<()> {
    coordinate.label = parse_text(input)?;
    parse_colon(input, "`:` and a unit")?;
    coordinate.unit = Some(parse_unit(input)?);
    while input.parse::<Option<Token![,]>>()?.is_some() {
        if input.cursor().ident().is_some_and(|(word, _)| word == "only" || word == "both") {
            parse_states(input, coordinate)?;
            continue;
        }
        let Some((span, direction)) = parse_direction(input)? else {
            let what = "a direction (`along y`, `about x`), `only rate`, `only position` or `both`";
            return Err(expected(input, what));
        };
        set_once(&mut coordinate.direction, direction, span)?;
    }
    parse_semicolon(input, "`,` or `;`", "the coordinate")
}

/// `only rate`, `only position` or `both`.
fn parse_states(input: ParseStream<'_>, coordinate: &mut Coordinate) -> syn::Result<()> {
    let first: syn::Ident = input.parse()?;
    let states = if first == "both" {
        States::Both
    } else {
        let what = "`rate` or `position` behind `only`: the one of them that the motion depends on";
        let word: syn::Ident = if input.peek(syn::Ident) { input.parse()? } else { return Err(expected(input, what)) };
        let states = States::from_name(&word.to_string());
        states.ok_or_else(|| error(&word, format!("found `{word}`: expected {what}")))?
    };
    if let Some((_, known)) = coordinate.only.replace((first.span(), states)) {
        let message = match (known, states) {
            (States::Both, States::Both) => "a second `both`: expected one",
            (States::Both, _) | (_, States::Both) => "`both` beside `only`: expected one of them",
            _ => "a second `only`: expected one",
        };
        return Err(error(&first, message));
    }
    Ok(())
}

/// Whether a parameter or a coordinate starts here.
fn starts_quantity(input: ParseStream<'_>) -> bool {
    input.peek(syn::Ident)
        && (input.peek2(Token![:]) && !input.peek2(Token![::]) || input.peek2(syn::LitStr) && input.peek3(Token![:]))
}
