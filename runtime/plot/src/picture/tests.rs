use carvallo_design::input::{self, Request};
use carvallo_design::units::Units;
use carvallo_design::{Design, MODELS};

use super::scene::Color;
use super::{Limits, Scene, bars, draw_along, draw_eigenvalues, draw_side_view, draw_tornado, font};
use crate::analysis::Analysis;
use crate::analysis::along::AlongAnalysis;
use crate::analysis::sensitivity::Changes;

/// What ships for a model, or the first of it.
fn design(model: &str, parameters: Option<&str>) -> Design {
    let request =
        Request { model: Some(model.to_owned()), parameters: parameters.map(str::to_owned), ..Request::default() };
    input::load(&request).unwrap()
}

fn eigenvalues(design: Design) -> Scene {
    let analysis = Analysis::new(design).unwrap();
    draw_eigenvalues(&analysis, Limits { x: (0.0, analysis.reach), y: None }).unwrap()
}

fn texts(scene: &Scene) -> impl Iterator<Item = &str> {
    scene.items.iter().filter_map(|item| item.text.as_deref())
}

/// Every model draws what it can, and of nothing that it writes there is no glyph.
#[test]
fn the_font_has_the_characters_of_every_picture() {
    let mut count = 0;
    for model in MODELS {
        let load = || design(model.info.name, None);
        let mut scenes: Vec<Scene> = Vec::new();
        if model.depends_on_speed() {
            scenes.push(eigenvalues(load()));
        }
        scenes.extend(draw_side_view(&load(), &Units::default()).map(|(scene, _)| scene));
        scenes.extend(Changes::new(load()).ok().and_then(|changes| draw_tornado(&changes)));
        for scene in &scenes {
            count += 1;
            assert!(scene.width > 0.0 && scene.height > 0.0 && !scene.title.is_empty());
            for text in texts(scene).chain([scene.title.as_str()]) {
                assert!(font::has(text), "{}: {text}", scene.title);
            }
        }
    }
    assert!(count > MODELS.len());
    for parameter in MODELS.iter().flat_map(|model| model.info.parameters) {
        assert!(font::has(parameter.symbol) && font::has(&carvallo_design::number::unit(parameter.unit)));
    }
}

/// What a chart cannot show is written below it in as many lines as it takes, and whole.
#[test]
fn notes_of_charts_are_whole() {
    let name = "a bicycle of which the name says where it was measured, by whom and with which tyres, ";
    let note = format!("Only {}{} has the capsize speed 5.4652 m/s", name.repeat(3), "x".repeat(200));
    let bars = |notes: Vec<String>| {
        let rows = vec![bars::Row { symbol: "w".to_owned(), beside: String::new(), values: vec![1.0] }];
        let [title, short_title, across] = ["title", "title", "across"].map(str::to_owned);
        let series = vec![("weave".to_owned(), Color(0, 0, 0))];
        bars::draw(&bars::Bars { title, short_title, series, rows, across, notes }).unwrap()
    };
    let (scene, without) = (bars(vec![note.clone(), "End".to_owned()]), bars(Vec::new()));
    let written: Vec<&str> =
        texts(&scene).skip_while(|text| !text.starts_with("Only")).take_while(|text| *text != "End").collect();
    assert_eq!(written.concat().replace(' ', ""), note.replace(' ', ""));
    assert!(
        written.len() > 3 && written.iter().all(|line| font::width(line, 13.0) <= scene.width - 48.0),
        "{written:?}"
    );
    assert!((scene.height - without.height - 19.0 * written.len() as f32).abs() < 0.1);
    assert_eq!(font::lines("", 13.0, 100.0), [""]);
}

/// The axes show what is near zero, and tell of the rest; critical values have their signs.
#[test]
fn modes_along_a_parameter_are_named() {
    let draw = |along: &str, speed: f64| {
        let analysis = AlongAnalysis::new(design("Whipple", None), &along.parse().unwrap(), Some(speed)).unwrap();
        draw_along(&analysis, None).unwrap()
    };
    let of_mass = draw("mB=60:120", 5.0);
    assert_eq!(of_mass.title, "Eigenvalues of benchmark against mB at 5 m/s");
    let count = |scene: &Scene, wanted: &str| texts(scene).filter(|text| *text == wanted).count();
    assert_eq!(["weave", "capsize", "mB (kg)", "mode 1"].map(|text| count(&of_mass, text)), [2, 1, 1, 0]);
    assert!(
        texts(&of_mass).any(|text| text.starts_with("Beyond the axes of real parts: all of castering, −14.9 to −13"))
    );
    let of_trail = draw("c=-0.05:0.2", 3.0);
    assert_eq!(["capsize −0.0025", "weave 0.0025"].map(|text| count(&of_trail, text)), [1, 1]);
}

/// Of one, four and 36 transfer functions: no name leaves the page, no two are at one place, and no two lines look the same.
#[cfg(feature = "control")]
#[test]
fn names_of_many_transfer_functions_stay_on_the_page() {
    use carvallo_control::{Ports, StateSpace};

    use super::draw_bode;
    use crate::analysis::transfer::Transfers;

    for (model, inputs) in [("Whipple", 1), ("Whipple", 2), ("Motorcycle", 6)] {
        let design = design(model, None);
        let ports = Ports::of(&design);
        let space = StateSpace::new(&design, 20.0, &ports.all_inputs()[..inputs], &ports.coordinates()).unwrap();
        let transfers = Transfers::new(&design, &space, None).unwrap();
        let scene = draw_bode(&transfers);
        let titles: Vec<String> = transfers.channels.iter().map(|channel| channel.title()).collect();
        let named = |item: &&super::scene::Item| item.text.as_ref().is_some_and(|text| titles.contains(text));
        let boxes: Vec<_> = scene.items.iter().filter(named).map(|item| item.path.bounds()).collect();
        assert_eq!(boxes.len(), titles.len());
        for (place, own) in boxes.iter().enumerate() {
            assert!(
                own.left() >= 0.0 && own.right() <= scene.width && own.bottom() <= scene.height,
                "{model}: {own:?}"
            );
            assert!(boxes[..place].iter().all(|other| own.intersect(other).is_none()), "{model}: {own:?}");
        }
        let looks: Vec<_> =
            (0..titles.len()).map(|place| (super::bode::color(place, 36), super::bode::paint(place))).collect();
        assert!((0..looks.len()).all(|place| !looks[..place].contains(&looks[place])), "{model}");
    }
}
