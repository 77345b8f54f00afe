//! Places in lists that are sorted by tag.

/// The first place in a list of ascending tags whose tag is not below `wanted`.
///
/// Where the tags count up one by one, as they mostly do, it is known without a search.
pub(super) fn first_place<T>(sorted: &[T], tag: impl Fn(&T) -> i64, wanted: i64) -> usize {
    let guess = sorted.first().and_then(|first| usize::try_from(wanted - tag(first)).ok());
    let is_first = |place: usize| {
        let here = sorted.get(place).is_some_and(|item| tag(item) == wanted);
        here && (place == 0 || tag(&sorted[place - 1]) < wanted)
    };
    match guess {
        Some(place) if is_first(place) => place,
        _ => sorted.partition_point(|item| tag(item) < wanted),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_of_equal_tags_is_found_and_where_a_missing_one_would_stand() {
        let place = |sorted: &[i64], wanted| first_place(sorted, |&tag| tag, wanted);
        assert_eq!(place(&[3, 4, 5], 4), 1);
        assert_eq!(place(&[3, 3, 3, 4], 3), 0);
        assert_eq!(place(&[1, 3, 3, 3], 3), 1);
        assert_eq!(place(&[-7, 2, 9], 9), 2);
        assert_eq!(place(&[-7, 2, 9], 3), 2);
        assert_eq!(place(&[-7, 2, 9], -8), 0);
        assert_eq!(place(&[], 1), 0);
    }
}
