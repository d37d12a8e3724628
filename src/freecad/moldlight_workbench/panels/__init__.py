"""Task panels, one file each."""
