"""Graphs for NetworkX, where it is installed."""


def to_networkx(graph):
    """The graph as a networkx.MultiGraph: nodes with name, border, position and cost; edges with place, distance and
    cost, and the number of the place as key. Costs may be infinite."""
    try:
        import networkx
    except ImportError as missing:
        raise ImportError("to_networkx() needs NetworkX. Install the package python3-networkx.") from missing
    made = networkx.MultiGraph()
    for number, node in enumerate(graph.nodes):
        made.add_node(number, name=node.name, border=node.border, position=node.position, cost=node.cost)
    for edge in graph.edges:
        made.add_edge(*edge.nodes, key=edge.place, place=edge.place, distance=edge.distance, cost=edge.cost)
    return made
