angle increment: 45
initial line width: 1
initial color: 1
tropism direction: 0,1,0
initial elasticity: 0.05
radii: pipe 2.15 0.16
material: 1 bark kind=bark bark=young-poplar color=0.46,0.43,0.37 roughness=1
material: 2 leaf kind=leaf color=0.29,0.47,0.17 roughness=0.45 translucency=0.45
organ: l leaf kind=blade material=2 length=9 width=8.4 petiole=4.2 widest=0.2 tip=1.2 base=0.35 fold=12 curl=20
