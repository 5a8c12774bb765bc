angle increment: 45
initial line width: 1
initial color: 1
tropism direction: 0,1,0
initial elasticity: 0.05
radii: pipe 2.35 0.22
material: 1 bark kind=bark color=0.36,0.29,0.23 roughness=0.95
material: 2 leaf kind=leaf color=0.30,0.47,0.16 roughness=0.55 translucency=0.45
organ: l leaf kind=blade material=2 length=13 width=8.5 petiole=3 widest=0.38 tip=0.9 base=0.2 fold=16 curl=28
