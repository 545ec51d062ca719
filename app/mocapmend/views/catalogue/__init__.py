"""The texts of packages without Qt, for Qt Linguist; `engine_texts` finds them again."""
