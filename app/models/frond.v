angle increment: 45
initial line width: 0.42
initial color: 1
tropism direction: 0,1,0
material: 1 rachis kind=stem color=0.45,0.52,0.22 roughness=0.7
material: 2 leaflet kind=leaf color=0.30,0.50,0.16 roughness=0.6 translucency=0.5
organ: l leaflet kind=blade material=2 length=1.8 width=1.1 petiole=0 widest=0.35 tip=0.6 base=0.7 fold=8 curl=18
