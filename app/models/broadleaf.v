angle increment: 45
initial line width: 1
initial color: 1
tropism direction: 0,1,0
radii: pipe 1.9 0.2
material: 1 bark kind=bark bark=maple color=0.42,0.37,0.31 roughness=1
material: 2 leaf kind=leaf color=0.30,0.47,0.16 roughness=0.55 translucency=0.45
organ: l leaf kind=blade material=2 length=11.5 width=8.2 petiole=2.6 widest=0.34 tip=1.15 base=0.05 fold=14 curl=30
