angle increment: 45
initial line width: 1
initial color: 1
radii: pipe 2.2 0.16
material: 1 bark kind=bark color=0.30,0.23,0.18 roughness=0.95
material: 2 needle kind=leaf color=0.13,0.27,0.16 roughness=0.6 translucency=0.1
organ: n needle kind=needle material=2 length=3.4 width=0.42 curl=12
