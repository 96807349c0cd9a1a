"""Graphs for NetworkX, where it is installed."""


def to_networkx(graph):
    """The graph as a networkx.MultiDiGraph: nodes with name, border, position and cost; edges with place, distance, cost
    and weight, and the number of the place as key. The weight has the cost of the edge's end, too: the coarse plan is the
    shortest way by weight. Costs may be infinite."""
    try:
        import networkx
    except ImportError as missing:
        raise ImportError("to_networkx() needs NetworkX. Install the package python3-networkx.") from missing
    made = networkx.MultiDiGraph()
    for number, node in enumerate(graph.nodes):
        made.add_node(number, name=node.name, border=node.border, position=node.position, cost=node.cost)
    for edge in graph.edges:
        made.add_edge(*edge.nodes, key=edge.place, place=edge.place, distance=edge.distance, cost=edge.cost,
                      weight=edge.cost + made.nodes[edge.nodes[1]]["cost"])
    return made
