"""Asset folders and objects: import, material nodes, and the files a job gets from the scene."""
