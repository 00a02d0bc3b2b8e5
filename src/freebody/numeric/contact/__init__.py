"""Contact, friction and impact in numbers: forces, impulses and their ranges from matrices, without any body."""
