//! Sorting, compiled once and small.

use core::cmp::Ordering;

/// The same as `sort_by` of slices, stable as that is.
///
/// That is 5 kB of code for each type and each order that it is asked for, which a web page has to load; few things are sorted
/// here, and few at a time. So there is one for all: it sorts places, and what stands there is then swapped into them. As for
/// slices, it takes about n log n comparisons.
pub fn sort_by<T>(values: &mut [T], mut compare: impl FnMut(&T, &T) -> Ordering) {
    // One value, of which most of what is sorted for a picture consists, needs no lists of places.
    if values.len() < 2 {
        return;
    }
    let order = sorted_places(values.len(), &mut |a, b| compare(&values[a], &values[b]));
    arrange(&order, &mut |a, b| values.swap(a, b));
}

/// Swaps what stands at the places of an order into it.
#[inline(never)]
fn arrange(order: &[usize], swap: &mut dyn FnMut(usize, usize)) {
    for place in 0..order.len() {
        // What was at a place before this one has been swapped on since.
        let mut from = order[place];
        while from < place {
            from = order[from];
        }
        swap(place, from);
    }
}

/// The places of so many values in their order. Merges ever longer runs.
#[inline(never)]
fn sorted_places(count: usize, compare: &mut dyn FnMut(usize, usize) -> Ordering) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    let mut merged = vec![0; count];
    let mut run = 1;
    while run < count {
        for start in (0..count).step_by(2 * run) {
            let (middle, end) = ((start + run).min(count), (start + 2 * run).min(count));
            let (mut left, mut right) = (start, middle);
            for place in &mut merged[start..end] {
                // Of equal ones the first stays first.
                let is_left = right == end || left < middle && compare(order[left], order[right]).is_le();
                let from = if is_left { &mut left } else { &mut right };
                *place = order[*from];
                *from += 1;
            }
        }
        core::mem::swap(&mut order, &mut merged);
        run *= 2;
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_that_of_slices() {
        for length in 0..40 {
            for seed in 0..50_u64 {
                // With many that are equal, of which the order stays.
                let key = |place: u64| (place + 1).wrapping_mul(6_364_136_223_846_793_005 + 2 * seed) >> 60;
                let mut values: Vec<(u64, u64)> = (0..length).map(|place| (key(place), place)).collect();
                let mut expected = values.clone();
                expected.sort_by_key(|pair| pair.0);
                sort_by(&mut values, |a, b| a.0.cmp(&b.0));
                assert_eq!(values, expected);
            }
        }
    }
}
