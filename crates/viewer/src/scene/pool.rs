//! Lists that keep their memory.

use std::ops::Deref;

/// A list whose items are kept, with their memory, when it is cleared.
#[derive(Clone, Debug, Default)]
pub struct Pool<T> {
    items: Vec<T>,
    used: usize,
}

impl<T> Pool<T> {
    /// Takes everything out.
    pub fn clear(&mut self) {
        self.used = 0;
    }

    /// Adds an item and gives it, as an earlier use has left it.
    pub fn add(&mut self) -> &mut T
    where
        T: Default,
    {
        if self.used == self.items.len() {
            self.items.push(T::default());
        }
        self.used += 1;
        &mut self.items[self.used - 1]
    }

    /// The items, to be changed.
    pub fn items_mut(&mut self) -> &mut [T] {
        &mut self.items[..self.used]
    }
}

impl<T> Deref for Pool<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.items[..self.used]
    }
}

impl<T: PartialEq> PartialEq for Pool<T> {
    fn eq(&self, other: &Pool<T>) -> bool {
        **self == **other
    }
}

impl<'a, T> IntoIterator for &'a Pool<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<T> FromIterator<T> for Pool<T> {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Pool<T> {
        let items: Vec<T> = items.into_iter().collect();
        Pool { used: items.len(), items }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cleared_pool_keeps_the_memory_of_its_items() {
        let mut pool = Pool::<Vec<u8>>::default();
        pool.add().extend([1, 2, 3]);
        pool.clear();
        assert!(pool.is_empty());
        let again = pool.add();
        assert!(again.capacity() >= 3);
        again.clear();
        assert_eq!(pool, Pool::from_iter([Vec::new()]));
    }
}
