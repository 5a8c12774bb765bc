angle increment: 45
initial line width: 1
initial color: 3
tropism direction: 0,1,0
radii: pipe 2.2 0.09
material: 1 twig kind=bark color=0.30,0.21,0.17 roughness=0.8
material: 2 leaf kind=leaf color=0.36,0.51,0.18 roughness=0.5 translucency=0.5
material: 3 bark kind=bark bark=birch color=0.86,0.84,0.79 roughness=1
organ: l leaf kind=blade material=2 length=6.2 width=4.7 petiole=1.6 widest=0.3 tip=1.0 base=0.4 fold=10 curl=20
leaf: l birch
calendar: l opens=4.1 grown=5.4 turns=9.1 bare=11.2
