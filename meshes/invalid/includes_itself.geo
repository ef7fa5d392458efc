// Never ends.
Include "includes_itself.geo";
